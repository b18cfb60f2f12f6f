"""Archives whose bytes are those of what is in them: names in order, owner 0, one time, the modes 755 and 644."""
import gzip
import lzma
import shutil
import tarfile
import time as clock
import zipfile


def compress(tar, archive):
    """The file as .xz."""
    with open(tar, "rb") as plain, lzma.open(archive, "wb") as packed:
        shutil.copyfileobj(plain, packed)


def write_tar(base, paths, file, time):
    """The paths, by their names below the folder `base`; each has the given time, in seconds since 1970."""
    def normal(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = "root"
        entry.mtime = time
        entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
        return entry

    with tarfile.open(fileobj=file, mode="w", format=tarfile.GNU_FORMAT) as tar:
        for path in paths:
            tar.add(path, path.relative_to(base), recursive=False, filter=normal)


def pack(folder, archive, time):
    """The folder, by its own name, as .tar.xz or .tar.gz."""
    def write(packed):
        write_tar(folder.parent, [folder, *sorted(folder.rglob("*"))], packed, time)

    if archive.suffix == ".gz":
        with open(archive, "wb") as file, gzip.GzipFile(filename="", fileobj=file, mode="wb", mtime=time) as packed:
            write(packed)
    else:
        with lzma.open(archive, "wb") as packed:
            write(packed)


def pack_zip(folder, archive, time):
    """The folder, by its own name, as .zip."""
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in sorted(folder.rglob("*")):
            if path.is_file():
                entry = zipfile.ZipInfo(path.relative_to(folder.parent).as_posix(), clock.gmtime(time)[:6])
                entry.external_attr = 0o100644 << 16
                packed.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED, 9)
