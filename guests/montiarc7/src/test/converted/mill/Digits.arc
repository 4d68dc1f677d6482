package mill;

/** Sums up the digits of a number, in slices. */
component Digits {
    timing instant;
    port in Integer number, out Integer sum, out Boolean even;
    <<completion = "ignore">> compute {
        Integer rest = number;
        Integer total = 0;
        total += rest % 10;
        rest = rest / (10);
        total += rest % 10;
        rest = rest / (10);
        total += rest % 10;
        rest = rest / (10);
        total += rest % 10;
        rest = rest / (10);
        sum = total;
        if (total % 2 == 0) {
            even = true;
        }
    }
}
