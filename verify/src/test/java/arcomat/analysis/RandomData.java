package arcomat.analysis;

import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Random components that pass data on, store them and ask whether they are equal. The same models
 * can be had with data of an enumeration, of which all can be tried, and of other types.
 */
public final class RandomData {
    private static final List<String> COMPLETIONS =
            List.of("chaos", "output", "ignore", "ignore", "ignore", "error");

    /** Data by their number; in the texts of models {@code @0}, {@code @1}. */
    public interface Kind {
        String type();

        String constant(int number);
    }

    /** All values of an enumeration. */
    public record Few(int count) implements Kind {
        @Override
        public String type() {
            return "D";
        }

        @Override
        public String constant(int number) {
            return "d" + number;
        }
    }

    /** More values than can be tried. */
    record Many(String type, String pattern) implements Kind {
        @Override
        public String constant(int number) {
            return pattern.replace("#", String.valueOf(number));
        }
    }

    public static final Kind INTEGERS = new Many("Integer", "#");
    public static final Kind LARGE_RANGE = new Many("Integer[-3..9000]", "#");
    public static final Kind STRINGS = new Many("String", "\"#\"");
    public static final Kind REALS = new Many("Double", "#.0");

    /** The variables and transitions of an automaton, and how it goes on where none fits. */
    private record Sketch(List<String> lines, String completion, String timing) {
        String text(String name) {
            return """
            component %s {
              timing %s;
              port in @T x, %sin @T z, in Boolean go, out @T y;
              <<completion = "%s">> automaton {
                variable @T v = @0;
                variable @T w = @0;
                state s, t, u;
                initial s;
            %s
              }
            }
            """
                    .formatted(
                            name,
                            timing,
                            timing.equals("untimed") ? "<<state>> " : "",
                            completion,
                            lines.stream().map(l -> "    " + l).collect(Collectors.joining("\n")));
        }
    }

    private final Random random;
    private final boolean two;
    private final boolean events;

    public RandomData(long seed) {
        this(seed, false);
    }

    /**
     * @param events whether there are events instead of slices; {@code z} is latched then
     */
    public RandomData(long seed, boolean events) {
        this.random = new Random(seed);
        this.two = random.nextInt(4) == 0;
        this.events = events;
    }

    /** The texts of components {@code Left} and {@code Right}, and of what they are made of. */
    public List<String> atoms() {
        Sketch right = sketch();
        Sketch left = random.nextInt(10) == 0 ? right : edited(right);
        return List.of(left.text("Left"), right.text("Right"));
    }

    /** Of these, both or one is made of two parts, one behind the other. */
    public List<String> chains() {
        Sketch first = sketch();
        Sketch second = sketch();
        Sketch other = random.nextBoolean() ? first : edited(first);
        Sketch another = random.nextBoolean() ? second : edited(second);
        return List.of(
                first.text("First"),
                second.text("Second"),
                other.text("Other"),
                another.text("Another"),
                chain("Right", "First", "Second"),
                chain("Left", "Other", "Another"));
    }

    private String chain(String name, String first, String second) {
        return """
        component %s {%s
          port in @T x, %sin @T z, in Boolean go, out @T y;
          component %s one;
          component %s two;
          connect x -> one.x;
          connect z -> one.z, two.z;
          connect go -> one.go, two.go;
          connect one.y -> two.x;
          connect two.y -> y;
        }
        """
                .formatted(
                        name,
                        events ? "\n  timing untimed;" : "",
                        events ? "<<state>> " : "",
                        first,
                        second);
    }

    public static Model model(List<String> texts, Kind kind) {
        List<SourceFile> files = new ArrayList<>();
        boolean few = kind instanceof Few;
        for (String text : texts) {
            String own = text.replace("@T", kind.type());
            for (int number = 0; number < 10; number++) {
                own = own.replace("@" + number, kind.constant(number));
            }
            String name = text.substring("component ".length(), text.indexOf(" {"));
            String head = few ? "package r;\nimport r.V.*;\n" : "package r;\n";
            files.add(new SourceFile("r/" + name + ".arc", head + own));
        }
        if (kind instanceof Few all) {
            String constants =
                    IntStream.range(0, all.count)
                            .mapToObj(all::constant)
                            .collect(Collectors.joining(", "));
            files.add(
                    new SourceFile(
                            "r/V.cd",
                            "package r;\nclassdiagram V { enum D { %s; } }\n"
                                    .formatted(constants)));
        }
        return ReadModels.model(files);
    }

    private Sketch sketch() {
        List<String> lines = new ArrayList<>();
        int count = 3 + random.nextInt(7);
        for (int i = 0; i < count; i++) {
            lines.add(transition());
        }
        return new Sketch(
                lines,
                any(COMPLETIONS),
                events ? "untimed" : random.nextInt(3) == 0 ? "instant" : "delayed");
    }

    private Sketch edited(Sketch sketch) {
        List<String> lines = new ArrayList<>(sketch.lines);
        switch (random.nextInt(4)) {
            case 0 -> lines.remove(random.nextInt(lines.size()));
            case 1 -> lines.add(transition());
            case 2 -> lines.set(random.nextInt(lines.size()), transition());
            default -> {
                int line = random.nextInt(lines.size());
                String[] halves = lines.get(line).split(" / ");
                lines.set(line, halves[0] + " / " + transition().split(" / ")[1]);
            }
        }
        boolean same = random.nextInt(4) > 0;
        boolean shifted = !events && random.nextInt(6) == 0;
        return new Sketch(
                lines,
                same ? sketch.completion : any(COMPLETIONS),
                shifted ? "instant" : sketch.timing);
    }

    private String transition() {
        List<String> asked = new ArrayList<>();
        boolean x = random.nextInt(3) > 0;
        boolean z = two && random.nextBoolean();
        if (x) {
            asked.add("x == " + any(List.of("?", "?", "?", "v", "w", "@0", "@1", "alt {@1, v}")));
        } else if (!events && random.nextInt(4) == 0) {
            asked.add("x == --");
        }
        if (z) {
            asked.add("z == " + any(List.of("?", "v", "@1")));
        }
        int go = random.nextInt(4);
        if (go < 3 && !(events && x)) {
            asked.add("go == " + List.of("true", "false", "--").get(go));
        }
        String source = any(List.of("s", "t", "t", "u"));
        String target = any(List.of("s", "t", "t", "u"));
        return "%s -> %s%s {%s} / {%s};"
                .formatted(source, target, guard(x, z), String.join(", ", asked), effect(x, z));
    }

    private String guard(boolean x, boolean z) {
        List<String> guards =
                new ArrayList<>(List.of("", "", " [v == w]", " [v != w]", " [v == @1]"));
        if (x) {
            guards.addAll(List.of(" [x != v]", " [x == v || v == @1]", " [!(x == w)]"));
        }
        if (x && z) {
            guards.addAll(List.of(" [x == z]", " [x != z]"));
        }
        return any(guards);
    }

    private String effect(boolean x, boolean z) {
        List<String> values = new ArrayList<>(List.of("v", "w", "@0", "@1", "@2"));
        if (x) {
            values.addAll(List.of("x", "x", "x", "x", "x == v ? w : x"));
        }
        if (z) {
            values.addAll(List.of("z", "z"));
        }
        List<String> effect = new ArrayList<>();
        if (random.nextInt(4) > 0) {
            String list = "[" + any(values) + ", " + any(values) + "]";
            String some = events && random.nextInt(5) == 0 ? list : any(values);
            effect.add("y = " + (random.nextInt(12) == 0 ? "?" : some));
        }
        for (String variable : List.of("v", "w")) {
            if (random.nextInt(3) == 0) {
                effect.add(variable + " = " + any(values));
            }
        }
        return String.join(", ", effect);
    }

    private <T> T any(List<T> list) {
        return list.get(random.nextInt(list.size()));
    }
}
