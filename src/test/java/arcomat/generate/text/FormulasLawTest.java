package arcomat.generate.text;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.language.Text;
import arcomat.generate.text.Formula.Bounds;
import arcomat.generate.text.Formula.Carries;
import arcomat.generate.text.Formula.Is;
import arcomat.generate.text.Formula.Test;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;

import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.BooleanSupplier;

/**
 * Conditions that are made shorter hold as before and go wrong as before, and two that are said to
 * exclude each other never hold together: for random formulas, in random slices.
 */
class FormulasLawTest {
    private static final int FORMULAS = 300;
    private static final int SLICES = 60;

    private static final Type.EnumType WORD = ComponentBuilder.enumeration("W", "a", "b", "c");
    private static final ComponentBuilder PORTS =
            ComponentBuilder.component("C")
                    .in(WORD, "x")
                    .in(WORD, "y")
                    .totalIn(WORD, "z")
                    .in(ComponentBuilder.BOOLEAN, "flag");

    private static final Optional<Boolean> NO = Optional.of(false);

    private final Simplification simplification = new Simplification(port -> !port.total());

    /**
     * What the fields of a component hold.
     *
     * @param silent ports without a message; a Boolean one still holds an old value
     * @param wrong whether a test that may go wrong does so
     */
    private record Slice(
            Map<String, Integer> words,
            boolean flag,
            List<String> silent,
            int number,
            int kept,
            boolean wrong) {
        static Slice any(Random random) {
            Map<String, Integer> words = new HashMap<>();
            List<String> silent = new ArrayList<>();
            for (String port : List.of("x", "y", "z")) {
                words.put(port, random.nextInt(3));
                if (!port.equals("z") && random.nextInt(3) == 0) {
                    silent.add(port);
                }
            }
            if (random.nextInt(3) == 0) {
                silent.add("flag");
            }
            return new Slice(
                    words,
                    random.nextBoolean(),
                    silent,
                    random.nextInt(6),
                    random.nextInt(3),
                    random.nextBoolean());
        }

        /** Whether it holds; empty where that goes wrong. */
        Optional<Boolean> look(Formula f) {
            return look(() -> holds(f));
        }

        static Optional<Boolean> look(BooleanSupplier condition) {
            try {
                return Optional.of(condition.getAsBoolean());
            } catch (ArithmeticException wrong) {
                return Optional.empty();
            }
        }

        private boolean holds(Formula f) {
            if (f instanceof Carries carries) {
                return carries.something() != silent.contains(carries.port().name());
            } else if (f instanceof Is is) {
                return isValue(is);
            } else if (f instanceof Test test) {
                if (wrong && test.mayFail()) {
                    throw new ArithmeticException();
                }
                return test.bounds()
                        .map(b -> b.low() <= number && number <= b.high())
                        .orElse(kept == 1);
            } else if (f instanceof Formula.Not not) {
                return !holds(not.operand());
            }
            Formula.Row row = (Formula.Row) f;
            return row.all()
                    ? row.operands().stream().allMatch(this::holds)
                    : row.operands().stream().anyMatch(this::holds);
        }

        private boolean isValue(Is is) {
            String port = is.port().name();
            if (port.equals("flag")) {
                return new Value.BooleanValue(flag).equals(is.constant().orElseThrow());
            }
            int value = is.constant().map(c -> ((Value.EnumValue) c).ordinal()).orElse(kept);
            return (!silent.contains(port) && words.get(port) == value) == is.equal();
        }
    }

    @RepeatedTest(5)
    void shorterFormsMeanTheSame(RepetitionInfo repetition) {
        Random random = new Random(repetition.getCurrentRepetition());
        int excluded = 0;
        for (int i = 0; i < FORMULAS; i++) {
            Formula f = formula(2, random);
            Formula g = formula(2, random);
            Formula h = formula(1, random);
            Formula and = simplification.and(List.of(f, g, h));
            Formula or = simplification.or(List.of(f, g, h));
            Formula not = simplification.not(f);
            Simplification.Excluded earlier = new Simplification.Excluded();
            List.of(g, h).forEach(each -> earlier.add(simplification.not(each).conjuncts()));
            Formula after =
                    simplification.inOpenCases(List.of(g, h), simplification.after(earlier, f));
            boolean excludes = Exclusion.contradict(f, g);
            boolean excludesBefore = Exclusion.contradict(f, g.beforeFailing());
            excluded += excludesBefore ? 1 : 0;
            for (int k = 0; k < SLICES; k++) {
                Slice slice = Slice.any(random);
                String what = List.of(f, g, h, slice).toString();
                Optional<Boolean> a = slice.look(f);
                assertThat(slice.look(and))
                        .as(what)
                        .isEqualTo(
                                Slice.look(
                                        () -> slice.holds(f) && slice.holds(g) && slice.holds(h)));
                assertThat(slice.look(or))
                        .as(what)
                        .isEqualTo(
                                Slice.look(
                                        () -> slice.holds(f) || slice.holds(g) || slice.holds(h)));
                assertThat(slice.look(not)).as(what).isEqualTo(a.map(holds -> !holds));
                if (slice.look(g).equals(NO) && slice.look(h).equals(NO)) {
                    assertThat(slice.look(after)).as(what).isEqualTo(a);
                }
                if (a.equals(Optional.of(true))) {
                    assertThat(excludes && slice.look(g).equals(a)).as(what).isFalse();
                    assertThat(excludesBefore && !slice.look(g).equals(NO)).as(what).isFalse();
                }
            }
        }
        assertThat(excluded).as("pairs that exclude each other").isGreaterThan(FORMULAS / 20);
    }

    private Formula formula(int depth, Random random) {
        if (depth == 0 || random.nextInt(4) == 0) {
            return atom(random);
        }
        List<Formula> operands = new ArrayList<>();
        for (int i = 1 + random.nextInt(3); i > 0; i--) {
            operands.add(formula(depth - 1, random));
        }
        return switch (random.nextInt(4)) {
            case 0 -> simplification.and(operands);
            case 1 -> simplification.or(operands);
            case 2 -> simplification.not(operands.get(0));
            default -> new Formula.Not(operands.get(0));
        };
    }

    /** What a flag holds counts only if there is a message. */
    private Formula atom(Random random) {
        Port port = PORTS.port(List.of("x", "y", "z").get(random.nextInt(3)));
        return switch (random.nextInt(8)) {
            case 0 -> new Carries(PORTS.port("flag"), random.nextBoolean());
            case 1 -> new Carries(port, random.nextBoolean());
            case 2 -> {
                boolean value = random.nextBoolean();
                yield simplification.and(
                        List.of(new Carries(PORTS.port("flag"), true), flag(value)));
            }
            case 3 -> {
                if (random.nextBoolean()) {
                    yield comparison(random.nextInt(6), random.nextBoolean());
                }
                int low = random.nextInt(6);
                Bounds bounds = new Bounds("n", low, low + random.nextInt(3));
                Text text = Text.primary(bounds.toString());
                yield new Test(text, text.text(), true, false, Optional.of(bounds));
            }
            case 4 ->
                    random.nextBoolean()
                            ? Test.of(Text.primary("any"), false)
                            : Test.of(Text.primary("risky"), true);
            case 5 -> is(port, random.nextBoolean(), Optional.empty());
            default -> is(port, random.nextBoolean(), Optional.of(random.nextInt(3)));
        };
    }

    private static Formula comparison(int limit, boolean less) {
        return new Test(
                Text.primary("n " + (less ? "< " : ">= ") + limit),
                "n < " + limit,
                less,
                false,
                Optional.of(less ? new Bounds("n", 0, limit - 1) : new Bounds("n", limit, 5)));
    }

    private static Formula flag(boolean value) {
        Text yes = Text.primary("flag");
        Text no = Text.primary("!flag");
        return new Is(
                PORTS.port("flag"),
                true,
                Optional.of(new Value.BooleanValue(value)),
                value ? yes : no,
                value ? no : yes);
    }

    private static Formula is(Port port, boolean equal, Optional<Integer> constant) {
        String value = constant.map(String::valueOf).orElse("kept");
        Text same = Text.primary(port.name() + " == " + value);
        Text other = Text.primary(port.name() + " != " + value);
        return new Is(
                port,
                equal,
                constant.map(ordinal -> new Value.EnumValue(WORD, ordinal)),
                equal ? same : other,
                equal ? other : same);
    }
}
