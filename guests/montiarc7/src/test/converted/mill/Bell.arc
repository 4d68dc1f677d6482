package mill;

/** Strikes, more than once for most questions. */
component Bell {
    timing untimed;
    port in Integer ask;
    port out Integer strike, out Boolean late;
    Integer all = 0;
    <<completion = "ignore">> automaton {
        state Ready;
        initial Ready / do {
            Integer strike1 = all;
            Integer strike2 = all;
            all = 5;
            strike = [strike1, -1, strike2];
        };
        // Known beforehand.
        Ready -> Ready [ask == 1] {ask == ?} / do {
            Integer strike1 = all;
            all = 5;
            strike = [0, 1, 3, strike1];
        };
        // What is sent changes afterwards.
        Ready -> Ready [ask == 2] {ask == ?} / do {
            all += 3;
            Integer strike1 = all;
            all += 2;
            Integer strike2 = all;
            all += 1;
            Integer strike3 = all;
            Integer strike4 = all;
            all = 5;
            strike = [strike1, strike2, strike3, strike4];
        };
        // Each round has its own sum.
        Ready -> Ready [ask == 3] {ask == ?} / do {
            Integer sum = 0 + all;
            sum++;
            Integer sum2 = 1 + all;
            sum2++;
            Integer sum3 = 2 + all;
            sum3++;
            Integer strike1 = all;
            all = 5;
            strike = [sum * 1, sum2 * 2, sum3 * 4, strike1];
        };
        Ready -> Ready [ask == 4] {ask == ?} / do {
            Integer strike1 = all;
            all = 5;
            strike = [10 * 1 + 1, 10 * 1 + 1, 10 * 2 + 1, 10 * 2 + 1, strike1];
        };
        // One, two or three.
        Ready -> Ready [ask > 4 && ask != 1 && ask != 2 && ask != 3] {ask == ?} / do {
            if (ask > 6) {
                Integer more = ask + 1;
                late = true;
                if (ask == 9) {
                    Integer strike1 = all;
                    all = 5;
                    strike = [1, more, 2, 9, strike1];
                } else if (ask == 5 || ask == 7) {
                    Integer strike2 = all;
                    all = 5;
                    strike = [1, more, 2, 5, strike2];
                } else {
                    Integer strike3 = all;
                    all = 5;
                    strike = [1, more, 2, strike3];
                }
            } else {
                Integer more = ask + 1;
                late = false;
                if (ask == 9) {
                    Integer strike4 = all;
                    all = 5;
                    strike = [more, 9, strike4];
                } else if (ask == 5 || ask == 7) {
                    Integer strike5 = all;
                    all = 5;
                    strike = [more, 5, strike5];
                } else {
                    Integer strike6 = all;
                    all = 5;
                    strike = [more, strike6];
                }
            }
        };
        Ready -> Ready [ask == 0 && !(ask > 4)] {ask == ?} / do {
            all = all;
            all--;
            Integer strike1 = all;
            Integer strike2 = all;
            all = 5;
            strike = [0, 1, 2, strike1, strike2];
        };
        // What is not there is not sent.
        Ready -> Ready [ask < 0 && ask != 1 && ask != 2 && ask != 3 && ask != 4 && !(ask > 4)]
                {ask == ?} / do {
            if (ask == -1) {
                Integer strike1 = all;
                all = 5;
                strike = [ask, 11, strike1];
            } else if (ask == -2) {
                late = true;
                Integer strike2 = all;
                all = 5;
                strike = [ask, strike2];
            } else {
                Integer strike3 = all;
                all = 5;
                strike = [ask, 12, strike3];
            }
        };
    }
}
