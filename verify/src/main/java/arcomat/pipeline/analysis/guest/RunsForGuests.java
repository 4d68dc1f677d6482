package arcomat.pipeline.analysis.guest;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.reachability.Subject;
import arcomat.guest.AutomatonRuns;
import arcomat.guest.AutomatonRuns.Reached;
import arcomat.guest.AutomatonRuns.Reaction;
import arcomat.guest.AutomatonRuns.Way;
import arcomat.model.Letter;

import java.util.List;
import java.util.stream.IntStream;

/** What an exploration has seen, in the words that guests know. */
final class RunsForGuests {
    private RunsForGuests() {}

    static AutomatonRuns of(Subject subject, Exploration explored, List<Situation> seen) {
        return new AutomatonRuns(
                subject.component(),
                subject.automaton(),
                subject.arguments(),
                IntStream.range(0, explored.size())
                        .mapToObj(number -> reached(explored.visit(number)))
                        .toList(),
                seen.stream().map(each -> reaction(each, subject)).toList(),
                explored.isComplete());
    }

    private static Reached reached(Visit visit) {
        return new Reached(
                visit.number(),
                visit.configuration().state(),
                visit.configuration().variables(),
                visit.before() == null);
    }

    private static Reaction reaction(Situation situation, Subject subject) {
        return new Reaction(
                situation.visit().number(),
                Letter.of(subject.component().inputs(), situation.letter()),
                situation.alternatives().stream()
                        .map(each -> new Way(each.taken().index(), each.next()))
                        .toList(),
                !situation.faults().isEmpty());
    }
}
