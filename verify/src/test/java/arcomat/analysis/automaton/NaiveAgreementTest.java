package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.NaiveExploration.Overlapping;
import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.RunProperties;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.semantics.expression.Fault;
import arcomat.source.SourceFile;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.statistics.Statistics;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * On random small automata the analyses find what trying all letters in all configurations finds,
 * with witnesses that are as short.
 */
class NaiveAgreementTest {
    private static final List<String> STATES = List.of("s0", "s1", "s2");

    @Tag("slow")
    @Property(seed = "1", tries = 200)
    void agree(@ForAll("automata") String text) {
        Component component =
                ReadModels.model(List.of(new SourceFile("Random.arc", text))).components().get(0);
        Examination examination = Models.examine(component).get(0);
        NaiveExploration naive = NaiveExploration.of(component);

        assertThat(examination.obstacle()).isEmpty();
        assertThat(lengths(examination, Overlap.CODE)).isEqualTo(overlaps(naive));
        assertThat(places(examination, Completeness.CODE)).isEqualTo(naive.unhandled());
        assertThat(places(examination, UnreachableState.CODE)).isEqualTo(naive.unreached());
        assertThat(places(examination, DeadTransition.CODE)).isEqualTo(naive.dead());
        assertThat(lengths(examination, RangeOverflow.CODE)).isEqualTo(naive.overflows());
        assertThat(lengths(examination, DivisionByZero.CODE)).isEqualTo(naive.divisions());
        assertThat(lengths(examination, Trap.CODE).values().stream().min(Integer::compare))
                .isEqualTo(naive.wayIntoATrap());
        assertThat(places(examination, VacuousOnSilence.CODE).isEmpty())
                .isEqualTo(naive.vacuous().isEmpty());
        Replay.all(examination);
        occurs("overlap", !naive.overlaps().isEmpty(), 30);
        occurs("run error", !naive.divisions().isEmpty() || !naive.overflows().isEmpty(), 10);
        occurs("all states reached", naive.unreached().isEmpty(), 10);
        occurs("trap behind a letter", naive.wayIntoATrap().orElse(0) > 0, 10);
    }

    /** Agreement says little where nothing is to be found. */
    private static void occurs(String what, boolean here, double percent) {
        Statistics.label(what)
                .collect(here)
                .coverage(all -> all.check(true).percentage(share -> share >= percent));
    }

    /**
     * Letters of the witness by the place of the finding, and by its words where it has several.
     */
    private static Map<String, Integer> lengths(Examination examination, String code) {
        Map<String, Integer> lengths = new TreeMap<>();
        for (Finding finding : findings(examination, code)) {
            String kind =
                    code.equals(Overlap.CODE)
                            ? finding.diagnostic().related().get(0).span().startPosition()
                                    + kind(finding.diagnostic().message())
                            : "";
            lengths.put(
                    finding.diagnostic().span().startPosition() + kind, finding.trace().size() - 1);
        }
        return lengths;
    }

    private static String kind(String message) {
        if (message.contains("same effect")) {
            return "SAME";
        }
        return message.contains("what is sent differs") ? "OBSERVABLE" : "HIDDEN";
    }

    private static Map<String, Integer> overlaps(NaiveExploration naive) {
        Map<String, Integer> lengths = new TreeMap<>();
        for (Map.Entry<Overlapping, Integer> each : naive.overlaps().entrySet()) {
            Overlapping pair = each.getKey();
            lengths.put(pair.first() + pair.second() + pair.kind(), each.getValue());
        }
        return lengths;
    }

    private static Set<String> places(Examination examination, String code) {
        return findings(examination, code).stream()
                .map(finding -> finding.diagnostic().span().startPosition().toString())
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static List<Finding> findings(Examination examination, String code) {
        return examination.findings().stream().filter(f -> f.code().equals(code)).toList();
    }

    /** What the solver answers is what trying everything answers, with runs that are as short. */
    @Tag("slow")
    @Property(seed = "2", tries = 12)
    void solverAgrees(@ForAll("automata") String text, @ForAll("solvers") Logic.Kind<?> solver) {
        for (Reachability outcome : agreed(text, solver)) {
            Statistics.label("outcome")
                    .collect(outcome.getClass().getSimpleName())
                    .coverage(
                            all -> {
                                all.check("Reachable").percentage(share -> share > 25);
                                all.check("Unreachable").percentage(share -> share > 25);
                                all.check("Unknown").percentage(share -> share < 15);
                            });
        }
    }

    /** Divisors with too many values for cases. */
    @Tag("slow")
    @Property(seed = "3", tries = 8)
    void solverAgreesAboutDivisions(
            @ForAll("divisions") String text, @ForAll("solvers") Logic.Kind<?> solver) {
        for (Reachability outcome : agreed(text, solver)) {
            Statistics.label("outcome of division")
                    .collect(outcome.getClass().getSimpleName())
                    .coverage(all -> all.check("Unreachable").percentage(share -> share > 25));
        }
    }

    /** Integers that wrap around, of 8 to 64 bits. */
    @Tag("slow")
    @Property(seed = "4", tries = 12)
    void solverAgreesAboutWrapping(
            @ForAll("wrapping") String text, @ForAll("solvers") Logic.Kind<?> solver) {
        for (Reachability outcome : agreed(text, solver)) {
            Statistics.label("outcome of wrapping")
                    .collect(outcome.getClass().getSimpleName())
                    .coverage(
                            all -> {
                                all.check("Reachable").percentage(share -> share > 10);
                                all.check("Unreachable").percentage(share -> share > 25);
                                all.check("Unknown").percentage(share -> share < 15);
                            });
        }
    }

    private static Collection<Reachability> agreed(String text, Logic.Kind<?> solver) {
        Component component =
                ReadModels.model(List.of(new SourceFile("Random.arc", text))).components().get(0);
        Automaton automaton = ((Component.Atomic) component.body()).automata().get(0);
        Subject subject = Subject.of(component, automaton, List.of());
        Exploration explored = new Exploration(subject, situation -> {}, Budget.ofMemory());
        explored.run();
        assertThat(explored.isComplete()).isTrue();
        NaiveExploration naive = NaiveExploration.of(component);

        Map<RunProperty, Reachability> outcomes =
                Models.answers(subject, new RunProperties(subject).all(), List.of(solver));

        outcomes.forEach(
                (question, outcome) -> {
                    if (outcome instanceof Reachability.Reachable found) {
                        assertThat(shown(explored)).contains(question);
                        assertThat(fewestLetters(question, automaton, naive))
                                .isIn(Optional.empty(), Optional.of(found.run().letters().size()));
                    } else if (outcome instanceof Reachability.Unreachable) {
                        assertThat(shown(explored)).doesNotContain(question);
                    }
                });
        return outcomes.values();
    }

    /** Empty for questions that are told by more than their number of letters. */
    private static Optional<Integer> fewestLetters(
            RunProperty question, Automaton automaton, NaiveExploration naive) {
        if (question instanceof RunProperty.Reached reached) {
            return Optional.of(naive.lettersTo(reached.state()));
        }
        if (question instanceof RunProperty.Wrong wrong) {
            Map<String, Integer> known =
                    wrong.kind() == Fault.Kind.DIVISION_BY_ZERO
                            ? naive.divisions()
                            : naive.overflows();
            Automaton.Transition transition = automaton.transitions().get(wrong.transition());
            return Optional.of(known.get(transition.span().startPosition().toString()));
        }
        return Optional.empty();
    }

    /** A silent letter may stand for letters with a message that nobody looks at. */
    private static Set<RunProperty> shown(Exploration explored) {
        Set<RunProperty> shown = new HashSet<>(explored.shown());
        for (RunProperty question : explored.shown()) {
            if (question instanceof RunProperty.Unhandled unhandled) {
                shown.add(new RunProperty.Unhandled(unhandled.state(), false));
            }
        }
        return shown;
    }

    @Provide
    Arbitrary<Logic.Kind<?>> solvers() {
        return Arbitraries.of(Models.SOLVERS);
    }

    @Provide
    Arbitrary<String> automata() {
        return Combinators.combine(
                        Arbitraries.of("chaos", "output", "ignore", "error"),
                        Arbitraries.of("silent", "free"),
                        lines().list().ofMinSize(3).ofMaxSize(10))
                .as(NaiveAgreementTest::text);
    }

    @Provide
    Arbitrary<String> divisions() {
        Arbitrary<String> left = Arbitraries.of("n / m", "n % m", "(n - 9) / m", "n % (m + 1)");
        Arbitrary<String> relation = Arbitraries.of("==", ">", "<");
        Arbitrary<String> right =
                Arbitraries.of("n", "m", "2", "-3", "34", "-34", "n + 1", "m - 1");
        Arbitrary<String> sent = Arbitraries.of("n / m", "n % m", "m");
        return Combinators.combine(left, relation, right, sent)
                .as(
                        (l, op, r, value) ->
                                """
                                component Random {
                                  port in Integer[-33..33] n, in Integer[-33..33] m,
                                       out Integer[-33..32] x;

                                  <<completion = "ignore">> automaton {
                                    state s0;
                                    initial s0;
                                    s0 [m != 0 && m != -1 && %s %s %s] / {x = %s};
                                    s0 [m == 5] {n == ?} / {x = n / m};
                                  }
                                }
                                """
                                        .formatted(l, op, r, value));
    }

    @Provide
    Arbitrary<String> wrapping() {
        Arbitrary<String> terms = Arbitraries.of("n", "m", "v", "(n + m)", "(n * m)", "(v - n)");
        Arbitrary<String> operations =
                Arbitraries.of(
                        " + 2147483645",
                        " - 2147483646",
                        " * 715827883",
                        " * 1073741824",
                        " * -2147483647",
                        " + -2147483648",
                        " + 9223372036854775806L",
                        " * 4611686018427387904L",
                        " % -3",
                        " / -1");
        Arbitrary<String> casts =
                Arbitraries.of("", "", "(byte) ", "(short) ", "(char) ", "(int) ", "-", "~");
        Arbitrary<String> relations = Arbitraries.of(" < ", " == ", " >= ");
        Arbitrary<String> limits =
                Arbitraries.of("0", "-1", "100", "2147483647", "-2147483648", "n", "v");
        Arbitrary<String> guards =
                Combinators.combine(casts, terms, operations, relations, limits)
                        .as(
                                (cast, term, op, is, limit) ->
                                        cast + "(" + term + op + ")" + is + limit);
        Arbitrary<String> effects =
                Arbitraries.of(
                        "v = n + 2147483645", "v = -2147483648", "x = v + n", "x = v * m", "v = 1");
        Arbitrary<String> lines =
                Combinators.combine(guards, guards, effects)
                        .as(
                                (one, two, effect) ->
                                        "s [%s && %s] / {%s};".formatted(one, two, effect));
        return lines.list()
                .ofMinSize(3)
                .ofMaxSize(5)
                .map(
                        all ->
                                """
                                component Random {
                                  port in Integer[-2..2] n, in Integer[0..3] m, out Integer x;

                                  <<completion = "ignore">> automaton {
                                    state s;
                                    variable Integer v = 0;
                                    initial s;
                                    %s
                                  }
                                }
                                """
                                        .formatted(String.join("\n    ", all)));
    }

    private static Arbitrary<String> lines() {
        Arbitrary<String> states = Arbitraries.of(STATES);
        Arbitrary<String> sources = Arbitraries.of("s0", "s0", "s1", "s2");
        Arbitrary<String> guards =
                Arbitraries.of(
                        "",
                        "",
                        "",
                        " [n > v]",
                        " [v < 2]",
                        " [n <= 1 && on]",
                        " [w == v]",
                        " [n == v || b == --]",
                        " [4 % v == 1]",
                        " [n + v > 4]",
                        " [v == 3]");
        Arbitrary<String> inputs =
                Arbitraries.of("", "", " {b == true}", " {b == --}", " {n == ?, b == false}");
        Arbitrary<String> outputs =
                Arbitraries.of(
                        "",
                        " / {x = 1}",
                        " / {x = v}",
                        " / {v = v + 1}",
                        " / {v = n, x = 2}",
                        " / {w = v, v = 0}",
                        " / {x = 6 / n}",
                        " / {y = true, v = w}",
                        " / {y = ?, v = 3 - v}",
                        " / {x = v, y = --}");
        return Combinators.combine(sources, states, guards, inputs, outputs)
                .as((from, to, guard, in, out) -> from + " -> " + to + guard + in + out + ";");
    }

    private static String text(String completion, String omitted, List<String> lines) {
        return """
        component Random {
          port in Boolean b, in Integer[0..3] n, <<total>> in Boolean on,
               out Integer[0..2] x, out Boolean y;

          <<completion = "%s", omitted = "%s">> automaton {
            state s0, s1, s2;
            variable Integer[0..3] v = 1;
            variable Integer[0..9] w = 2;
            initial s0;
            %s
          }
        }
        """
                .formatted(completion, omitted, String.join("\n    ", lines))
                .replace(
                        "<<total>> in Boolean on",
                        lines.size() % 2 == 0 ? "<<total>> in Boolean on" : "in Boolean on");
    }
}
