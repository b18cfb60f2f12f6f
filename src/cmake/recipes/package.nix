{
  lib,
  stdenv,
  fetchurl,
  cmake,
  ninja,
  gmp,
  mpfr,
  flint,
  boost,
  fmt,
  cli11,
  nlohmann_json,
  libzip,
  pugixml,
  zstd,
  zlib,
  openssl,
  cairo,
}:

stdenv.mkDerivation {
  pname = "exactmdm";
  version = "0.2.0";

  src = fetchurl {
    url = "@SOURCE_URL@";
    sha256 = "@SHA256@";
  };

  strictDeps = true;

  nativeBuildInputs = [
    cmake
    ninja
  ];

  buildInputs = [
    cli11
    nlohmann_json
    libzip
    pugixml
    zstd
    zlib
    openssl
    cairo
  ];

  # mdmConfig.cmake looks for them.
  propagatedBuildInputs = [
    gmp
    mpfr
    flint
    boost
    fmt
  ];

  cmakeFlags = [
    (lib.cmakeBool "MDM_TESTS" false)
    (lib.cmakeBool "MDM_BENCHMARKS" false)
  ];

  postInstall = ''
    mv $out/share/zsh/vendor-completions $out/share/zsh/site-functions
  '';

  doInstallCheck = true;
  installCheckPhase = ''
    runHook preInstallCheck
    PATH=$out/bin:$PATH
    printf 'size_mm,mass\n0.15,2\n0.3,1\n0.6,0\n' > sand.csv
    mdm solve sand.csv --proof sand.proof
    mdm-check sand.csv sand.proof | grep 'N = 4 is the smallest number of particles'
    runHook postInstallCheck
  '';

  # There is no homepage yet.
  meta = {
    description = "Exact minimal discrete matches of grain size distributions";
    license = lib.licenses.asl20;
    maintainers = [ ];
    mainProgram = "mdm";
    platforms = lib.platforms.linux; # memfd_create, prctl
  };
}
