package mill;

/** What Java does with bits. */
component Code {
    timing instant;
    port in Integer a, in Integer b, in Long c, in Boolean p, in Boolean q;
    port
        out Integer low,
        out Integer half,
        out Integer more,
        out Integer upper,
        out Integer other;
    port out Long far;
    port
        out Boolean both,
        out Boolean one,
        out Boolean any,
        out Boolean high,
        out Boolean same,
        out Boolean clear;
    port out Boolean over, out Boolean none, out Boolean some, out Boolean differ;
    <<completion = "ignore">> compute {
        low = ((a % 8 + 8) % 8);
        half = (a >= 0 ? a / 2 : -1 - (-1 - a) / 2);
        more = (a * 1073741824);
        upper = (a >= 0 ? a / 268435456 : 15 - (-1 - a) / 268435456);
        other = (-1 - (a + b));
        far = (c >= 0 ? c / 2147483648L : 8589934591L - (-1 - c) / 2147483648L);
        both = (p && q);
        one = (p != q);
        any = (p || q);
        high = !(a >= 0 && a < 8 && b >= 0 && b < 8);
        same = (a == b);
        clear = (a == 0 && c == 0);
        Integer sum = a + b;
        over = (((a < 0) != (sum < 0)) && ((b < 0) != (sum < 0)));
        none = !((a < 0) || (b < 0));
        some = !((a < 0) && (b < 0));
        differ = ((a < 0) != (c < 0));
    }
}
