# deltaform on Debian 12:
#     docker build --tag deltaform .
#     docker run --rm --volume "$PWD:/work" deltaform my.prm --output my_results
FROM debian:12 AS build
COPY . /deltaform
WORKDIR /deltaform
RUN scripts/setup.sh dpkg-dev file \
 && cmake --preset release -DDELTAFORM_TESTS=OFF && cmake --build --preset release \
 && cd build/release && cpack -G DEB && mv deltaform_*.deb /deltaform.deb

FROM debian:12
COPY --from=build /deltaform.deb /tmp/
RUN apt-get update && apt-get install --yes --no-install-recommends /tmp/deltaform.deb libopenblas0-serial \
 && rm -rf /tmp/deltaform.deb /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["deltaform"]
