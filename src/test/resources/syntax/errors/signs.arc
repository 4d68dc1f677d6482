component Signs {
    port in Integer speed;
    port in Integer 🤖, out Integer 𝑥;
　   port in Integer quiet​;
    automaton { state  s;
        initial s
     ; }
}
