package arcomat.analysis.refinement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.Function;

/**
 * Two random automata that calculate with messages of unbounded types, and whether one refines the
 * other, told apart from the tool: guards are drawn as texts of a model and of SMT-LIB at once,
 * with vectors of bits and IEEE 754, and steps are compared pair by pair.
 */
public final class RandomQuestion {
    /** A condition, or a number that is sent. */
    private record Drawn(String model, String smt) {}

    /**
     * @param sent null for nothing
     */
    private record Row(int source, Drawn guard, Drawn sent, int target) {}

    private static final List<String> INTEGERS = List.of("p", "q");

    /** Whatever takes longer, is not known. */
    private static final String IN_BITS =
            "(check-sat-using (using-params qffpbv :max_conflicts 1000))";

    private static final List<Double> REALS = List.of(0.0, 0.5, 1.0, 0.1, 2.0, 1.5, 10.0, 3.0);
    private static final List<Integer> CONSTANTS = List.of(0, 1, 2, 3, 7, -1, 100);

    private final Random random;
    private final boolean reals;
    private final List<Row> left = new ArrayList<>();
    private final List<Row> right = new ArrayList<>();

    public RandomQuestion(long seed) {
        this(seed, false);
    }

    /**
     * @param reals whether they mostly calculate with Doubles, and send such
     */
    public RandomQuestion(long seed, boolean reals) {
        this.reals = reals;
        random = new Random(seed);
        int rows = 2 + random.nextInt(3);
        for (int i = 0; i < rows; i++) {
            int source = i == 0 ? 0 : random.nextInt(2);
            Drawn[] alike = condition();
            Drawn[] sent = random.nextInt(5) == 0 ? new Drawn[] {null, null} : number();
            int target = random.nextInt(2);
            right.add(new Row(source, alike[0], sent[0], target));
            left.add(new Row(source, alike[1], sent[1], target));
        }
        if (random.nextBoolean()) {
            int changed = random.nextInt(rows);
            Row row = left.get(changed);
            boolean guard = row.sent == null || random.nextInt(3) > 0;
            left.set(
                    changed,
                    new Row(
                            row.source,
                            guard ? condition()[0] : row.guard,
                            guard ? row.sent : number()[0],
                            row.target));
        }
    }

    /** The same condition written in two ways. */
    private Drawn[] condition() {
        Drawn[] one = atom();
        if (random.nextInt(3) > 0) {
            return one;
        }
        Drawn[] two = atom();
        boolean and = random.nextBoolean();
        return new Drawn[] {
            connected(and, one[0], two[0]), connected(and, two[1], one[1]),
        };
    }

    private static Drawn connected(boolean and, Drawn one, Drawn two) {
        return new Drawn(
                "(%s) %s (%s)".formatted(one.model, and ? "&&" : "||", two.model),
                "(%s %s %s)".formatted(and ? "and" : "or", one.smt, two.smt));
    }

    private Drawn[] atom() {
        if (reals && random.nextInt(3) > 0) {
            return calculated();
        }
        return switch (random.nextInt(10)) {
            case 0, 1, 2 -> integers(term(), term());
            case 3, 4 -> integers(read(), constant());
            case 5 -> rest();
            case 6 -> reals();
            case 7 -> texts();
            default -> integers(read(), read());
        };
    }

    private Drawn read() {
        String port = INTEGERS.get(random.nextInt(2));
        return new Drawn(port, port);
    }

    private Drawn constant() {
        int value = CONSTANTS.get(random.nextInt(CONSTANTS.size()));
        return new Drawn(String.valueOf(value), vector(value));
    }

    private static String vector(int value) {
        return "#x%08x".formatted(value);
    }

    private Drawn term() {
        Drawn port = read();
        int constant = 1 + random.nextInt(3);
        return switch (random.nextInt(4)) {
            case 0 ->
                    new Drawn(
                            port.model + " + " + constant,
                            "(bvadd " + port.smt + " " + vector(constant) + ")");
            case 1 ->
                    new Drawn(
                            constant + " * " + port.model,
                            "(bvmul " + vector(constant) + " " + port.smt + ")");
            case 2 -> {
                Drawn other = read();
                yield new Drawn(
                        port.model + " - " + other.model,
                        "(bvsub " + port.smt + " " + other.smt + ")");
            }
            default -> port;
        };
    }

    private Drawn[] integers(Drawn one, Drawn two) {
        return switch (random.nextInt(4)) {
            case 0 -> both(one, "<", two, ">", "bvslt");
            case 1 -> both(one, "<=", two, ">=", "bvsle");
            case 2 -> both(one, "==", two, "==", "=");
            default -> {
                String smt = "(not (bvslt " + one.smt + " " + two.smt + "))";
                yield new Drawn[] {
                    new Drawn(one.model + " >= " + two.model, smt),
                    new Drawn("!(" + one.model + " < " + two.model + ")", smt),
                };
            }
        };
    }

    private static Drawn[] both(Drawn one, String sign, Drawn two, String turned, String function) {
        String smt = "(" + function + " " + one.smt + " " + two.smt + ")";
        return new Drawn[] {
            new Drawn(one.model + " " + sign + " " + two.model, smt),
            new Drawn(two.model + " " + turned + " " + one.model, smt),
        };
    }

    private Drawn[] rest() {
        Drawn port = read();
        int divisor = 2 + random.nextInt(3);
        int rest = random.nextInt(divisor);
        String smt = "(= (bvsrem %s %s) %s)".formatted(port.smt, vector(divisor), vector(rest));
        return new Drawn[] {
            new Drawn(port.model + " % " + divisor + " == " + rest, smt),
            new Drawn("!(" + port.model + " % " + divisor + " != " + rest + ")", smt),
        };
    }

    private Drawn[] reals() {
        return switch (random.nextInt(3)) {
            case 0 -> both(new Drawn("d", "d"), "<", new Drawn("e", "e"), ">", "fp.lt");
            case 1 ->
                    both(
                            new Drawn("d", "d"),
                            "<=",
                            new Drawn("1.5", "((_ to_fp 11 53) #x3ff8000000000000)"),
                            ">=",
                            "fp.leq");
            default -> both(new Drawn("d", "d"), "==", new Drawn("e", "e"), "==", "fp.eq");
        };
    }

    /** Doubles that are calculated with, compared with others. */
    private Drawn[] calculated() {
        Drawn[] one = real();
        Drawn two = random.nextBoolean() ? realConstant() : real()[0];
        int kind = random.nextInt(5);
        if (kind == 0) {
            Drawn cut = cut(realRead());
            return integers(cut, constant());
        }
        String[] signs = {"<", "<=", ">", ">=", "=="};
        String[] functions = {"fp.lt", "fp.leq", "fp.gt", "fp.geq", "fp.eq"};
        String[] turned = {">", ">=", "<", "<=", "=="};
        int sign = random.nextInt(signs.length);
        String smt = "(" + functions[sign] + " " + one[0].smt + " " + two.smt + ")";
        return new Drawn[] {
            new Drawn(one[0].model + " " + signs[sign] + " " + two.model, smt),
            new Drawn(two.model + " " + turned[sign] + " " + one[1].model, smt),
        };
    }

    private Drawn realRead() {
        String port = random.nextBoolean() ? "d" : "e";
        return new Drawn(port, port);
    }

    private Drawn realConstant() {
        double value = REALS.get(random.nextInt(REALS.size()));
        return new Drawn(String.valueOf(value), vector(value));
    }

    private static String vector(double value) {
        return "((_ to_fp 11 53) #x%016x)".formatted(Double.doubleToRawLongBits(value));
    }

    /** The same in two ways. */
    private Drawn[] real() {
        Drawn port = realRead();
        Drawn other = random.nextInt(3) == 0 ? realRead() : realConstant();
        return switch (random.nextInt(7)) {
            case 0 -> calculated(port, "+", "fp.add", other, true);
            case 1 -> calculated(port, "-", "fp.sub", other, false);
            case 2 -> calculated(port, "*", "fp.mul", realConstant(), true);
            case 3 -> calculated(port, "/", "fp.div", realConstant(), false);
            case 4 -> twice(new Drawn("-" + port.model, "(fp.neg " + port.smt + ")"));
            case 5 -> {
                Drawn whole = read();
                yield twice(
                        new Drawn(
                                "(double) " + whole.model,
                                "((_ to_fp 11 53) RNE " + whole.smt + ")"));
            }
            default -> twice(port);
        };
    }

    private static Drawn[] twice(Drawn drawn) {
        return new Drawn[] {drawn, drawn};
    }

    private static Drawn[] calculated(
            Drawn one, String sign, String function, Drawn two, boolean commutes) {
        String smt = "(" + function + " RNE " + one.smt + " " + two.smt + ")";
        Drawn drawn = new Drawn(one.model + " " + sign + " " + two.model, smt);
        Drawn turned = new Drawn(two.model + " " + sign + " " + one.model, smt);
        return new Drawn[] {drawn, commutes ? turned : drawn};
    }

    /** As Java cuts off: nothing beyond the ends of whole numbers. */
    private static Drawn cut(Drawn port) {
        String smt =
                "(ite (fp.isNaN %1$s) %2$s (ite (fp.geq %1$s %3$s) %4$s (ite (fp.leq %1$s %5$s)"
                        + " %6$s ((_ fp.to_sbv 32) RTZ %1$s))))";
        return new Drawn(
                "(int) " + port.model,
                smt.formatted(
                        port.smt,
                        vector(0),
                        vector(0x1p31),
                        vector(Integer.MAX_VALUE),
                        vector(-0x1p31),
                        vector(Integer.MIN_VALUE)));
    }

    private Drawn[] texts() {
        return random.nextBoolean()
                ? both(
                        new Drawn("t", "t"),
                        "==",
                        new Drawn("\"a\"", reals ? "#x01" : "1"),
                        "==",
                        "=")
                : both(new Drawn("t", "t"), "==", new Drawn("u", "u"), "==", "=");
    }

    private Drawn[] number() {
        if (reals) {
            return real();
        }
        Drawn drawn = random.nextInt(3) == 0 ? constant() : term();
        Drawn again =
                drawn.model.contains(" + ")
                        ? new Drawn(drawn.model.replaceFirst("(.*) \\+ (.*)", "$2 + $1"), drawn.smt)
                        : drawn;
        return new Drawn[] {drawn, again};
    }

    /** The models {@code Left} and {@code Right}. */
    public List<String> models() {
        return List.of(text("Left", left), text("Right", right));
    }

    /**
     * The same models, but that {@code p} comes to the automaton of the left one by way of two
     * other parts, the second of which undoes what the first has done.
     */
    List<String> composed() {
        String there = WAYS.get(random.nextInt(WAYS.size()));
        String core = text("Core", left);
        return List.of(
                COMPOSED.formatted(
                        part("There", there),
                        part("Back", there.replace(" + ", " - ")),
                        core.indent(2).strip()),
                text("Right", right));
    }

    private static final List<String> WAYS =
            List.of(
                    "s / {y = x};",
                    "s / {y = x + 12};",
                    "s / {y = x + q};",
                    "s [x > q] / {y = x + q}; s [x <= q] / {y = x + q};",
                    "s [q % 3 == 0] / {y = x}; s [q % 3 != 0] / {y = x + 1};");

    private static String part(String name, String transitions) {
        return """
        component %s {
            timing instant;
            port <<total>> in Integer x, <<total>> in Integer q, <<total>> out Integer y;
            <<completion = "error">> automaton { state s; initial s; %s }
          }
        """
                .formatted(name, transitions)
                .strip();
    }

    private static final String COMPOSED =
            """
            component Left {
              port <<total>> in Integer p, <<total>> in Integer q, <<total>> in Double d,
                   <<total>> in Double e, <<total>> in String t, <<total>> in String u, out Integer o;
              %s
              %s
              %s
              component There there;
              component Back back;
              component Core core;
              connect p -> there.x;
              connect there.y -> back.x;
              connect back.y -> core.p;
              connect q -> there.q, back.q, core.q;
              connect d -> core.d;
              connect e -> core.e;
              connect t -> core.t;
              connect u -> core.u;
              connect core.o -> o;
            }
            """;

    private String text(String name, List<Row> rows) {
        StringBuilder lines = new StringBuilder();
        for (Row row : rows) {
            lines.append("    s%d -> s%d [%s]".formatted(row.source, row.target, row.guard.model));
            lines.append(row.sent == null ? ";\n" : " / {o = " + row.sent.model + "};\n");
        }
        return """
        component %s {
          port <<total>> in Integer p, <<total>> in Integer q, <<total>> in Double d,
               <<total>> in Double e, <<total>> in String t, <<total>> in String u, out %s o;
          <<completion = "ignore">> automaton {
            state s0, s1;
            initial s0;
        %s  }
        }
        """
                .formatted(name, reals ? "Double" : "Integer", lines);
    }

    /**
     * Whether the left one refines the right one, by a subset construction in which every step is a
     * question to a solver.
     *
     * @param solver gives one answer for each question of a script
     * @return null where the solver does not know
     */
    Boolean holds(Function<List<String>, List<String>> solver) {
        Set<List<Object>> met = new LinkedHashSet<>(Set.of(List.of(0, Set.of(0))));
        List<List<Object>> open = new ArrayList<>(met);
        while (!open.isEmpty()) {
            List<Object> pair = open.remove(0);
            int state = (Integer) pair.get(0);
            @SuppressWarnings("unchecked")
            Set<Integer> others = (Set<Integer>) pair.get(1);
            List<Row> own = completed(left, state);
            List<Row> theirs = new ArrayList<>();
            others.forEach(each -> theirs.addAll(completed(right, each)));
            Map<Integer, List<Object>> next = new HashMap<>();
            List<String> script = new ArrayList<>(declarations());
            int questions = 0;
            for (Row row : own) {
                for (int subset = 0; subset < 1 << theirs.size(); subset++) {
                    List<String> all = new ArrayList<>(List.of(row.guard.smt));
                    Set<Integer> targets = new LinkedHashSet<>();
                    for (int i = 0; i < theirs.size(); i++) {
                        boolean answers = (subset >> i & 1) == 1;
                        String same = same(row, theirs.get(i));
                        all.add(answers ? same : "(not " + same + ")");
                        if (answers) {
                            targets.add(theirs.get(i).target);
                        }
                    }
                    script.add("(push)(assert (and " + String.join(" ", all) + "))");
                    script.add((reals ? IN_BITS : "(check-sat)") + "(pop)");
                    next.put(questions++, List.of(row.target, targets));
                }
            }
            List<String> answers = solver.apply(script);
            for (int i = 0; i < questions; i++) {
                if (answers.size() != questions || answers.get(i).equals("unknown")) {
                    return null;
                }
                if (answers.get(i).equals("sat")) {
                    if (((Set<?>) next.get(i).get(1)).isEmpty()) {
                        return false;
                    }
                    if (met.add(next.get(i))) {
                        open.add(next.get(i));
                    }
                }
            }
        }
        return true;
    }

    /** Texts are numbers; of these, too, Z3 has to know nothing but bits where reals are. */
    private List<String> declarations() {
        String text = reals ? " (_ BitVec 8))" : " Int)";
        List<String> lines = new ArrayList<>();
        INTEGERS.forEach(port -> lines.add("(declare-const " + port + " (_ BitVec 32))"));
        List.of("d", "e")
                .forEach(p -> lines.add("(declare-const " + p + " (_ FloatingPoint 11 53))"));
        List.of("t", "u").forEach(port -> lines.add("(declare-const " + port + text));
        return lines;
    }

    /** With what is done where none fits: nothing is sent. */
    private static List<Row> completed(List<Row> rows, int state) {
        List<Row> all = new ArrayList<>(rows.stream().filter(row -> row.source == state).toList());
        StringBuilder any = new StringBuilder("(or false");
        all.forEach(row -> any.append(' ').append(row.guard.smt));
        all.add(new Row(state, new Drawn("", "(not " + any + "))"), null, state));
        return all;
    }

    private static String same(Row one, Row two) {
        if (one.sent == null || two.sent == null) {
            return one.sent == two.sent ? two.guard.smt : "false";
        }
        return "(and " + two.guard.smt + " (= " + one.sent.smt + " " + two.sent.smt + "))";
    }
}
