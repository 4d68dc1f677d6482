package arcomat.analysis.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.evolution.Edits.Edit;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Model;
import arcomat.semantics.Promise;
import arcomat.source.Span;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Versions as data: {@code verify/src/test/resources/analysis/evolution.txt}. Below {@code == edits
 * A B} stands a line for each edit that makes B of A, and below it what is left of B without it,
 * where that can be made. Below {@code == versions A B ..} stands a line for each version with its
 * answers to all earlier ones, then a line for each promise that stopped being kept, with the edits
 * that are to blame, and last the answer to all.
 */
class EvolutionTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analysis/evolution.txt");

    @TestFactory
    Stream<DynamicTest> versions() {
        Sections sections = Sections.read(DATA);
        Model model = sections.model();
        return sections.all().stream()
                .filter(each -> !each.kind().equals("file"))
                .map(
                        each ->
                                DynamicTest.dynamicTest(
                                        each.kind() + " " + each.rest(), () -> check(model, each)));
    }

    private static void check(Model model, Sections.Section asked) {
        List<Promise> versions =
                Arrays.stream(asked.rest().split(" "))
                        .map(name -> VerdictsTest.promise(model, name, '-'))
                        .toList();
        List<String> lines =
                asked.kind().equals("edits")
                        ? edits(versions.get(0), versions.get(1))
                        : evolution(Evolution.of(versions, Budget.ofMemory()));
        assertThat(lines).isEqualTo(asked.lines());
    }

    private static List<String> edits(Promise before, Promise after) {
        List<String> lines = new ArrayList<>();
        for (Edit edit : Edits.between(before, after)) {
            lines.add(text(edit.old(), edit.fresh()));
            edit.undone()
                    .ifPresent(
                            undone ->
                                    lines.add(
                                            undone.automata().stream()
                                                    .map(EvolutionTest::text)
                                                    .collect(Collectors.joining(" | ", "- ", ""))));
        }
        return lines;
    }

    private static List<String> evolution(Evolution evolution) {
        List<String> lines = new ArrayList<>();
        for (int version = 0; version < evolution.titles().size(); version++) {
            lines.add(
                    evolution.titles().get(version)
                            + ": "
                            + evolution.verdicts().get(version).stream()
                                    .map(verdict -> word(verdict.answer()))
                                    .collect(Collectors.joining(" ")));
        }
        for (Evolution.Break each : evolution.breaks()) {
            lines.add(
                    evolution.titles().get(each.version())
                            + " breaks "
                            + evolution.titles().get(each.promise())
                            + " by "
                            + each.culprits().stream()
                                    .map(culprit -> text(culprit.old(), culprit.fresh()))
                                    .collect(Collectors.joining(", ")));
        }
        lines.add(word(evolution.answer()));
        return lines.stream().map(String::strip).toList();
    }

    private static String word(Verdict.Answer answer) {
        return answer.name().toLowerCase(Locale.ROOT);
    }

    private static String text(Automaton automaton) {
        return word(automaton)
                + " "
                + Stream.concat(
                                automaton.initials().stream().map(Automaton.Initial::span),
                                automaton.transitions().stream().map(Automaton.Transition::span))
                        .map(EvolutionTest::text)
                        .collect(Collectors.joining(" "));
    }

    private static String word(Automaton automaton) {
        return automaton.completion().name().toLowerCase(Locale.ROOT);
    }

    private static String text(Optional<Span> old, Optional<Span> fresh) {
        return old.map(EvolutionTest::text).orElse("nothing")
                + " becomes "
                + fresh.map(EvolutionTest::text).orElse("nothing");
    }

    private static String text(Span span) {
        return span.firstLine().text().strip();
    }
}
