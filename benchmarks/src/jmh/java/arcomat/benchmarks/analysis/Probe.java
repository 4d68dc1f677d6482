package arcomat.benchmarks.analysis;

import arcomat.analysis.*;

public class Probe {
    static void time(String what, int warm, Promise a, Promise b) {
        for (int i = 0; i <= warm; i++) {
            System.gc();
            long used = Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
            long t = System.nanoTime();
            Verdict v = Refinement.check(a, b, new Budget(() -> false, 100_000_000));
            double ms = (System.nanoTime() - t) / 1e6;
            long now = Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
            System.out.printf(
                    "%s: %.2f ms %s %s %s sim %s heap +%d MB%n",
                    what,
                    ms,
                    v.answer(),
                    v.reason(),
                    v.explored(),
                    v.simulation(),
                    (now - used) >> 20);
        }
    }

    public static void main(String[] args) throws Exception {
        Models c = Models.coffee();
        for (int i = 0; i < 2000; i++) {
            Refinement.check(
                    c.promise("coffee.fig6.AvoidCrash"),
                    c.promise("coffee.fig5.AvoidCrash"),
                    Budget.ofMemory());
        }
        time(
                "fig6<=fig5",
                2,
                c.promise("coffee.fig6.AvoidCrash"),
                c.promise("coffee.fig5.AvoidCrash"));
        for (int r = 0; r < 5; r++) {
            long t = System.nanoTime();
            for (int i = 0; i < 5000; i++) {
                Refinement.check(
                        c.promise("coffee.fig6.AvoidCrash"),
                        c.promise("coffee.fig5.AvoidCrash"),
                        Budget.ofMemory());
            }
            System.out.println("fig " + (System.nanoTime() - t) / 5000e3 + " us");
        }
        for (int n : new int[] {20}) {
            Models m = Models.of(Texts.random("A", n, 50, 7), Texts.random("B", n, 100, 7));
            time("random " + n, 2, m.promise("load.A"), m.promise("load.B"));
        }
        for (int[] n :
                new int[][] {
                    {31, 32}, {99, 101}, {316, 317}, {997, 1009}, {2719, 2729}, {3162, 3163}
                }) {
            Models m = Models.of(Texts.counter("A", n[0]), Texts.counter("B", n[1]));
            time("counters " + n[0] * n[1], 1, m.promise("load.A"), m.promise("load.B"));
        }
        Models w = Models.of(Texts.wide("A", 1000, 0, 3), Texts.wide("B", 1000, 30, 3));
        time("wide", 1, w.promise("load.A"), w.promise("load.B"));
        Models p =
                Models.of(
                        Texts.stage("P", true),
                        Texts.stage("Q", false),
                        Texts.pipeline("A", "P", 100),
                        Texts.pipeline("B", "Q", 100));
        time("pipeline", 8, p.promise("load.A"), p.promise("load.B"));
    }
}
