package mill;

/** What Java's numbers have. */
component Limits {
    timing instant;
    port in Integer a, in Integer b;
    port out Integer least, out Integer most, out Integer size;
    port out Boolean full, out Boolean empty;
    port out char letter;
    <<completion = "ignore">> compute {
        least = (a <= (b + 1) ? a : (b + 1));
        most = (a >= b ? a : b);
        size = ((a - b) < 0 ? -(a - b) : (a - b));
        full = a == 2147483647;
        if (b == 0) {
            empty = true;
        }
        if (b != 0) {
            empty = false;
            letter = 'x';
        }
    }
}
