from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Exactmdm(CMakePackage):
    """Exact minimal discrete matches of grain size distributions"""

    # There is no homepage yet.
    url = "@SOURCE_URL@"

    license("Apache-2.0")

    version("0.2.0", sha256="@SHA256@")

    generator("ninja")

    variant("python", default=False, description="Build the Python module")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("cli11@2.1:", type="build")
    depends_on("nlohmann-json@3.11:", type="build")

    depends_on("gmp+cxx")
    depends_on("mpfr")
    depends_on("flint@3:")
    depends_on("boost@1.74:")
    depends_on("fmt@9:")
    depends_on("libzip")
    depends_on("pugixml")
    depends_on("zstd")
    depends_on("zlib-api")
    depends_on("openssl")
    depends_on("cairo+zlib+ft+fc+png+pdf")

    with when("+python"):
        extends("python")
        depends_on("python@3.11:", type="build")
        depends_on("py-pybind11@2.10:", type="build")

    requires("platform=linux", msg="The programs call memfd_create and prctl of Linux")

    def cmake_args(self):
        args = [
            self.define("MDM_TESTS", False),
            self.define("MDM_BENCHMARKS", False),
            self.define_from_variant("MDM_PYTHON", "python"),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("Python_EXECUTABLE", self.spec["python"].command.path))
            args.append(self.define("MDM_PYTHON_FOLDER", python_platlib))
        return args

    def test_solve_and_check(self):
        """the smallest match of a small gradation, and its proof"""
        with open("sand.csv", "w") as gradation:
            gradation.write("size_mm,mass\n0.15,2\n0.3,1\n0.6,0\n")
        solve = which(self.prefix.bin.mdm)
        solve("solve", "sand.csv", "--proof", "sand.proof")
        check = which(join_path(self.prefix.bin, "mdm-check"))
        verdict = check("sand.csv", "sand.proof", output=str.split, error=str.split)
        assert "N = 4 is the smallest number of particles" in verdict, verdict
