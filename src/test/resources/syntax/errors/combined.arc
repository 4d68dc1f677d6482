component Combined {
    port in Integer café, in Integer q̃;
}
