package arcomat.fuzz;

import java.nio.file.*;
import java.util.*;

public class Explore {
    public static void main(String[] a) throws Exception {
        List<ModelSet> sets =
                List.of(
                        ModelSet.folder("coffee", Path.of("models/coffee")),
                        ModelSet.folder("truth", Path.of("src/test/resources/truth")),
                        ModelSet.page("language", Path.of("docs/language.md")));
        List<Harmless> laws = sets.stream().map(Harmless::new).toList();
        long from = Long.parseLong(a[0]), to = Long.parseLong(a[1]);
        if (a.length > 2) {
            int k = (int) (from % sets.size());
            System.out.println(
                    new Damage(sets, from).apply(sets.get(k)).differenceFrom(sets.get(k)));
            laws.get(k).check(new Damage(sets, from).apply(sets.get(k)));
            return;
        }
        Map<String, Integer> seen = new HashMap<>();
        long start = System.nanoTime();
        for (long seed = from; seed < to; seed++) {
            int i = (int) (seed % sets.size());
            ModelSet damaged = null;
            long t0 = System.nanoTime();
            try {
                damaged = new Damage(sets, seed).apply(sets.get(i));
                laws.get(i).check(damaged);
            } catch (Throwable e) {
                StringBuilder key = new StringBuilder(e.getClass().getName());
                int n = 0;
                for (StackTraceElement x : e.getStackTrace()) {
                    if (x.getClassName().startsWith("arcomat.") && n++ < 3)
                        key.append("\n   ").append(x);
                }
                if (e instanceof IllegalArgumentException || e instanceof IllegalStateException)
                    key.append("\n")
                            .append(
                                    String.valueOf(e.getMessage())
                                            .replaceAll("[0-9]+", "N")
                                            .replaceAll("(?s)(.{120}).*", "$1"));
                int count = seen.merge(key.toString(), 1, Integer::sum);
                if (count <= 2) {
                    System.out.println("######## seed " + seed + " set " + sets.get(i).name());
                    System.out.println(key);
                    String m = String.valueOf(e.getMessage());
                    System.out.println(m.length() > 700 ? m.substring(0, 700) : m);
                    if (damaged != null)
                        Files.writeString(
                                Path.of("/tmp/w/found-" + seed), diff(sets.get(i), damaged));
                    System.out.println(damaged == null ? "" : cut(diff(sets.get(i), damaged)));
                }
            }
            long ms = (System.nanoTime() - t0) / 1000000;
            if (ms > 4000) System.out.println("######## SLOW seed " + seed + " " + ms);
        }
        System.out.println(
                "done " + (to - from) + " in " + (System.nanoTime() - start) / 1000000 + " ms");
        seen.forEach((k, v) -> System.out.println(v + " x " + k));
    }

    static String cut(String s) {
        return s.length() > 1500 ? s.substring(0, 1500) : s;
    }

    static String diff(ModelSet o, ModelSet d) {
        StringBuilder b = new StringBuilder();
        for (var f : d.files().keySet()) {
            if (!o.files().containsKey(f)) {
                b.append("NEW ").append(f).append("\n");
                continue;
            }
            if (o.text(f).equals(d.text(f))) continue;
            b.append("==== ").append(f).append("\n");
            List<String> x = o.text(f).lines().toList(), y = d.text(f).lines().toList();
            Set<String> xs = new HashSet<>(x), ys = new HashSet<>(y);
            for (String l : x) if (!ys.contains(l)) b.append("- ").append(l).append("\n");
            for (String l : y) if (!xs.contains(l)) b.append("+ ").append(l).append("\n");
            if (x.size() != y.size()) b.append("lines " + x.size() + " " + y.size() + "\n");
        }
        for (var f : o.files().keySet())
            if (!d.files().containsKey(f)) b.append("GONE ").append(f).append("\n");
        return b.toString();
    }
}
