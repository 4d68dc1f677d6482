component Hostile {
    port in String text, in Integer number, out String echo;

    automaton {
        variable Integer count = 0;
        state waiting, done;

        initial waiting;

        waiting -> done {text == "</text><script>alert(1)</script>"} / {echo = "& \" ' <b>"};
        waiting [number > 100 && number < 2000 && number != 1234 || number == -1 || number == -2 || number == -3]
            / {count = count + (number - 1) * 2, echo = "a string that is so long that no line of a label can hold it without a cut"};
    }
}
