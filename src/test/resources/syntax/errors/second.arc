component First {
    port in Boolean a;
}

component Second {
    port in Boolean a;
}
