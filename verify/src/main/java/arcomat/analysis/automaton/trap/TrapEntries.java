package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.exploration.Confirmation;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Stepper;
import arcomat.analysis.automaton.exploration.Traps;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.automaton.induction.CandidateConditions;
import arcomat.analysis.automaton.induction.InductiveConditions;
import arcomat.analysis.automaton.induction.Move;
import arcomat.analysis.automaton.induction.Region;
import arcomat.analysis.bits.BitLogic;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability.Run;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.Unrolling;
import arcomat.analysis.reachability.Unrolling.StatePredicate;
import arcomat.analysis.smt.LinearLogic;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Which traps are entered, and how: shortest runs, that the automaton itself agrees with. */
final class TrapEntries {
    /** Longer runs are not looked for. */
    private static final int LONGEST = 12;

    private final Subject subject;
    private final Knowledge known;
    private final Insight insight;
    private final BooleanSupplier stop;
    private final Confirmation confirmation;

    TrapEntries(Subject subject, Knowledge known, Insight insight, BooleanSupplier stop) {
        this.subject = subject;
        this.known = known;
        this.insight = insight;
        this.stop = stop;
        this.confirmation = new Confirmation(subject, Stepper.of(subject));
    }

    Traps traps() {
        List<Traps.Entry> entered = new ArrayList<>();
        String obstacle = "";
        for (List<Region> group : groups()) {
            Entrance entrance = entrance(group);
            if (entrance.visit().isPresent()) {
                entered.add(entry(entrance.visit().get()));
            } else if (entrance.isOpen()) {
                obstacle = "in %s there is one, but it is open whether a run gets there";
                obstacle = obstacle.formatted(names(group));
            } else if (isEnteredByLatching(group)) {
                obstacle = "in %s there is one as soon as latched ports have had a message";
                obstacle = obstacle.formatted(names(group));
            }
        }
        return new Traps(entered, obstacle);
    }

    private Entrance entrance(List<Region> group) {
        Entrance linear = entrance(group, LinearLogic.KIND);
        Entrance entrance = linear.isOpen() ? entrance(group, BitLogic.KIND) : linear;
        return entrance.visit().isPresent()
                ? entrance
                : new Entrance(explored(group), entrance.isOpen());
    }

    /**
     * A latched port may have a message at any time, but runs are looked at for transitions only:
     * what happens where none awaits that message is not claimed to be no trap.
     */
    private boolean isEnteredByLatching(List<Region> group) {
        if (group.stream().allMatch(each -> each.latched().isEmpty())) {
            return false;
        }
        Entrance entrance = entrance(group.stream().map(Region::withoutLatched).toList());
        return entrance.visit().isPresent() || entrance.isOpen();
    }

    private String names(List<Region> group) {
        return states(group).stream().map(subject::state).collect(Collectors.joining(", "));
    }

    /** Traps with a common state are one. */
    private List<List<Region>> groups() {
        List<List<Region>> groups = new ArrayList<>();
        for (Region region : insight.traps) {
            List<Region> joined = new ArrayList<>(List.of(region));
            for (List<Region> group : List.copyOf(groups)) {
                if (group.stream().anyMatch(region::meets)) {
                    groups.remove(group);
                    joined.addAll(group);
                }
            }
            groups.add(joined);
        }
        return groups;
    }

    private static Set<Integer> states(List<Region> group) {
        Set<Integer> states = new TreeSet<>();
        group.forEach(each -> states.addAll(each.conditions().keySet()));
        return states;
    }

    /**
     * A way into a trap.
     *
     * @param isOpen whether there may be one where none is known
     */
    private record Entrance(Optional<Visit> visit, boolean isOpen) {}

    private <T> Entrance entrance(List<Region> group, Logic.Kind<T> kind) {
        Logic<T> logic = kind.about(subject, stop);
        Logic<T> other = kind.about(subject, stop);
        Unrolling<T> fromStart = new Unrolling<>(subject, true, logic);
        Unrolling<T> fromAnywhere = new Unrolling<>(subject, false, other);
        fromStart.exclude(insight.facts().contradicted(logic));
        fromAnywhere.exclude(insight.facts().contradicted(other));
        for (int length = 0; length <= LONGEST; length++) {
            fromStart.extend();
            fromAnywhere.extend();
            List<Run> found = new ArrayList<>();
            Logic.Answer answer = fromStart.endsWith(in(group, logic), found::add);
            if (answer == Logic.Answer.YES) {
                Optional<Visit> visit = confirmed(found.get(0), group);
                return new Entrance(visit, visit.isEmpty());
            }
            if (answer == Logic.Answer.UNKNOWN) {
                return new Entrance(Optional.empty(), true);
            }
            if (fromAnywhere.endsFirstWith(in(group, other)) == Logic.Answer.NO) {
                return new Entrance(Optional.empty(), false);
            }
        }
        return new Entrance(Optional.empty(), true);
    }

    private static <T> StatePredicate<T> in(List<Region> group, Logic<T> logic) {
        return there -> logic.or(group.stream().map(each -> each.at(there, logic)).toList());
    }

    private Optional<Visit> confirmed(Run run, List<Region> group) {
        Set<Integer> kept = new TreeSet<>();
        group.forEach(each -> kept.addAll(positions(each.latched())));
        return confirmation.reaching(run, kept).filter(visit -> isIn(group, visit));
    }

    private List<Integer> positions(Set<Port> ports) {
        return ports.stream().map(subject.component().inputs()::indexOf).toList();
    }

    private boolean isIn(List<Region> group, Visit visit) {
        Spot spot = new Spot(visit.configuration(), Set.of());
        return group.stream()
                .anyMatch(
                        each ->
                                visit.latched().containsAll(positions(each.latched()))
                                        && spot.satisfies(
                                                each.in(visit.configuration().state()), subject));
    }

    /** One that was seen when configurations were tried: longer than runs of the solver. */
    private Optional<Visit> explored(List<Region> group) {
        return IntStream.range(0, known.explored().size())
                .mapToObj(known.explored()::visit)
                .filter(visit -> isIn(group, visit))
                .reduce(Visit::simpler);
    }

    /** The states that it may come to from there, as far as one can tell. */
    private Traps.Entry entry(Visit visit) {
        Traps.Entry entry = entry(visit, LinearLogic.KIND);
        return entry.isWhole() ? entry : entry(visit, BitLogic.KIND);
    }

    private <T> Traps.Entry entry(Visit visit, Logic.Kind<T> kind) {
        Set<Port> latched =
                visit.latched().stream()
                        .map(subject.component().inputs()::get)
                        .filter(subject.latchable()::contains)
                        .collect(Collectors.toSet());
        List<Move> moves = Move.all(known);
        InductiveConditions<T> induction =
                new InductiveConditions<>(subject, moves, kind.about(subject, stop));
        Set<Integer> states =
                induction
                        .from(
                                List.of(visit.configuration()),
                                latched,
                                new CandidateConditions(subject, moves).all())
                        .keySet();
        RunsFromSpot<T> runs = new RunsFromSpot<>(subject, kind, stop);
        Spot spot = new Spot(visit.configuration(), latched);
        boolean isWhole =
                states.size() == 1
                        || states.stream().allMatch(state -> runs.reaches(state, spot))
                                && runs.isExact();
        return new Traps.Entry(visit, states, isWhole);
    }
}
