package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.RandomPairs;
import arcomat.analysis.Sections;
import arcomat.analysis.Verdicts;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Shortcuts change no answer. In {@code refinement/shortcuts.txt}, {@code == takes SHORTCUT A B}
 * says that a question takes one; such a question, and each of the other data and of random pairs
 * that takes it, is asked again without it.
 */
class ShortcutsTest {
    private static final int ENOUGH = 4;

    /** What no solver can be asked takes no shortcut, and long. */
    private static final String NOT_ASKED = "cannot be put exactly to the solver";

    private static final Budget ENOUGH_PAIRS = new Budget(() -> false, 20_000);

    private record Question(String name, Promise left, Promise right) {
        Outcome ask(Budget budget) {
            TraceInclusion.Result result =
                    ComparedSystems.of(left, right, budget).inclusion(budget).run();
            return new Outcome(
                    result.failure().map(TraceInclusion.Failure::level),
                    result.failure().map(TraceInclusion.Failure::cost),
                    result.stopped(),
                    result.simulation(),
                    result.chaosReached() && !result.promising());
        }
    }

    /**
     * What must be the same; how many pairs were explored is not.
     *
     * @param empty whether nothing is promised after any input
     */
    private record Outcome(
            Optional<Integer> length,
            Optional<Integer> messages,
            Optional<String> stopped,
            Optional<Boolean> simulation,
            boolean empty) {}

    /**
     * The others are asked about elsewhere: they are none of a search, or come after 200,000 pairs
     * only ({@link SymbolicInclusionTest}).
     */
    private static final Set<Shortcut> ELSEWHERE =
            EnumSet.of(
                    Shortcut.PART_BY_PART,
                    Shortcut.LONG_PIPELINE,
                    Shortcut.IMPATIENCE,
                    Shortcut.SYMBOLIC,
                    Shortcut.CONDITIONS);

    @Tag("slow")
    @Test
    void changeNoAnswer() throws IOException {
        Map<Shortcut, Integer> compared = new EnumMap<>(Shortcut.class);
        for (Question question : questions()) {
            Set<Shortcut> taken = EnumSet.noneOf(Shortcut.class);
            Outcome quick = question.ask(ENOUGH_PAIRS.with(noting(taken)));
            taken.removeAll(ELSEWHERE);
            for (Shortcut shortcut : taken) {
                Outcome thorough = question.ask(ENOUGH_PAIRS.with(each -> each != shortcut));
                if (thorough.stopped.isEmpty()) {
                    assertThat(quick).as("%s: %s", shortcut, question.name).isEqualTo(thorough);
                    compared.merge(shortcut, 1, Integer::sum);
                }
            }
        }
        for (Shortcut shortcut : EnumSet.complementOf(EnumSet.copyOf(ELSEWHERE))) {
            assertThat(compared.getOrDefault(shortcut, 0))
                    .as("questions that take %s", shortcut)
                    .isGreaterThanOrEqualTo(ENOUGH);
        }
    }

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> isTaken() {
        Sections sections = Sections.read(VerdictsTest.FOLDER.resolve("shortcuts.txt"));
        Model model = sections.model();
        return sections.of("takes").stream()
                .map(
                        section ->
                                DynamicTest.dynamicTest(
                                        section.rest(), () -> take(model, section)));
    }

    private static void take(Model model, Sections.Section section) {
        String[] words = section.rest().split(" ");
        Shortcut shortcut = Shortcut.valueOf(words[0].toUpperCase(Locale.ROOT).replace('-', '_'));
        Promise left = VerdictsTest.promise(model, words[1], '-');
        Promise right = VerdictsTest.promise(model, words[2], '-');
        String expected = section.lines().get(0);
        Set<Shortcut> taken = EnumSet.noneOf(Shortcut.class);
        Verdict quick = Refinement.check(left, right, Budget.ofMemory().with(noting(taken)));
        assertThat(taken).contains(shortcut);
        assertThat(Verdicts.text(quick, expected)).isEqualTo(expected);
        Verdict thorough =
                Refinement.check(left, right, Budget.ofMemory().with(each -> each != shortcut));
        String without = section.lines().get(section.lines().size() - 1);
        assertThat(Verdicts.text(thorough, without)).as("without it").isEqualTo(without);
    }

    private static Predicate<Shortcut> noting(Set<Shortcut> taken) {
        return shortcut -> {
            taken.add(shortcut);
            return true;
        };
    }

    private static List<Question> questions() throws IOException {
        List<Question> questions = new ArrayList<>();
        try (Stream<Path> files = Files.list(VerdictsTest.FOLDER)) {
            files.sorted().forEach(file -> addAll(file, questions));
        }
        RandomPairs.any(71, 80)
                .forEach(p -> questions.add(new Question(p.toString(), p.left(), p.right())));
        RandomPairs.conjunctions(72, 20)
                .forEach(q -> questions.add(new Question("conjunction", q.left(), q.right())));
        RandomNetworks networks = new RandomNetworks(73);
        for (int i = 0; i < 8; i++) {
            RandomNetworks.Question next = networks.question();
            questions.add(new Question(next.text(), next.left(), next.right()));
        }
        return questions;
    }

    private static void addAll(Path file, List<Question> questions) {
        Sections sections = Sections.read(file);
        Model model = sections.model();
        for (Sections.Section ask : sections.of("ask")) {
            String[] names = ask.rest().split(" ");
            for (String line : ask.lines()) {
                String sides = line.split(" ")[0];
                Promise left = VerdictsTest.promise(model, names[0], sides.charAt(0));
                Promise right =
                        VerdictsTest.promise(model, names[1], sides.charAt(sides.length() - 1));
                if (Refinement.comparable(left, right).isEmpty() && !line.contains(NOT_ASKED)) {
                    questions.add(new Question(ask.rest() + " " + line, left, right));
                }
            }
        }
    }
}
