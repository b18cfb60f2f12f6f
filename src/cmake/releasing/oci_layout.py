"""An image for containers as one file, an OCI image layout: JSON and archives, each by the digest of its bytes.

The formats are those of the OCI Image Format Specification 1.0.
"""
import gzip
import hashlib
import json
import pathlib
import tempfile

from . import archives


def digest(content):
    return f"sha256:{hashlib.sha256(content).hexdigest()}"


def packed(root, time):
    """All that is in the folder, as .tar and as .tar.gz."""
    with tempfile.TemporaryFile() as file:
        archives.write_tar(root, sorted(root.rglob("*")), file, time)
        file.seek(0)
        tar = file.read()
    return tar, gzip.compress(tar, mtime=time)


def add_blob(folder, kind, content):
    """Adds a blob to the layout; returns how others name it."""
    name = digest(content)
    path = folder / "blobs" / name.replace(":", "/")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    return {"mediaType": f"application/vnd.oci.image.{kind}", "digest": name, "size": len(content)}


def add_json(folder, kind, value):
    return add_blob(folder, kind, json.dumps(value).encode())


def write(file, root, name, configuration, time):
    """Writes the image NAME of one layer, the files in the folder `root`. The configuration lacks what the layer says."""
    tar, layer = packed(root, time)
    configuration = {**configuration, "rootfs": {"type": "layers", "diff_ids": [digest(tar)]}}
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        manifest = {"schemaVersion": 2, "mediaType": "application/vnd.oci.image.manifest.v1+json",
                    "config": add_json(folder, "config.v1+json", configuration),
                    "layers": [add_blob(folder, "layer.v1.tar+gzip", layer)]}
        named = {**add_json(folder, "manifest.v1+json", manifest), "annotations": {"org.opencontainers.image.ref.name": name}}
        index = {"schemaVersion": 2, "mediaType": "application/vnd.oci.image.index.v1+json", "manifests": [named]}
        (folder / "index.json").write_text(json.dumps(index), encoding="utf-8")
        (folder / "oci-layout").write_text(json.dumps({"imageLayoutVersion": "1.0.0"}), encoding="utf-8")
        with open(file, "wb") as archive:
            archives.write_tar(folder, sorted(folder.rglob("*")), archive, time)
