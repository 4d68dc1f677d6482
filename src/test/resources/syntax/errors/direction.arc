component Direction {
    port in Integer a‮;
    Java inv ordered: { /* fine */ int ⁦ x; };
}
