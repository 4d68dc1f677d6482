package arcomat.analysis.automaton.exploration;

import arcomat.analysis.automaton.exploration.Visit.Place;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Letters;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Output;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * All configurations that an automaton can reach, breadth first, with one letter of each kind that
 * a configuration tells apart. Completions lead nowhere new: they keep the configuration, or end in
 * chaos or error.
 */
public final class Exploration {
    private final Subject subject;
    private final Stepper stepper;
    private final Consumer<Situation> watching;
    private final Budget budget;

    private final Map<Place, Visit> visits = new HashMap<>();
    private final List<Visit> byNumber = new ArrayList<>();
    private final Map<InputAbstraction, List<Value[]>> alphabets = new HashMap<>();
    private final BitSet connected;
    private final Set<RunProperty> shown = new HashSet<>();
    private Map<Place, Visit> next = new LinkedHashMap<>();
    private String obstacle = "";

    public Exploration(Subject subject, Consumer<Situation> watching, Budget budget) {
        this.subject = subject;
        this.stepper = Stepper.of(subject);
        this.watching = watching;
        this.budget = budget;
        this.connected = Subject.connected(subject.automaton());
    }

    /** Shows all that can happen to those who watch. */
    public void run() {
        for (Start start : subject.relation().starts()) {
            Place place = new Place(start.configuration(), Set.of());
            propose(place, null, null, start.output());
        }
        explore();
    }

    private void explore() {
        while (!next.isEmpty()) {
            List<Visit> level = new ArrayList<>(next.values());
            level.sort(Comparator.comparingInt(Visit::messages));
            next = new LinkedHashMap<>();
            level.forEach(visit -> visits.put(visit.place(), visit));
            if (!obstacle.isEmpty()) {
                return; // what is found further on would not be the shortest
            }
            for (Visit visit : level) {
                String exhausted = budget.exhausted(byNumber.size());
                if (exhausted != null) {
                    obstacle = exhausted;
                    return;
                }
                lookAround(visit);
            }
        }
    }

    private void lookAround(Visit visit) {
        try {
            for (Value[] letter : letters(visit)) {
                budget.insist();
                if (isPossible(letter, visit)) {
                    Situation situation = situation(visit, letter);
                    shown.addAll(situation.shows());
                    watching.accept(situation);
                }
            }
        } catch (GivenUp stopped) {
            obstacle = String.valueOf(stopped.getMessage());
        }
    }

    private List<Value[]> letters(Visit visit) {
        InputAbstraction abstraction = subject.relation().abstraction(visit.configuration());
        List<Value[]> known = alphabets.get(abstraction);
        if (known == null) {
            known = Letters.of(subject.component(), abstraction);
            alphabets.put(abstraction, known);
        }
        return known;
    }

    /** A port that has latched a message never loses it. */
    private boolean isPossible(Value[] letter, Visit visit) {
        if (visit.latched().isEmpty()) {
            return true;
        }
        InputAbstraction abstraction = subject.relation().abstraction(visit.configuration());
        return visit.latched().stream()
                .noneMatch(
                        port ->
                                letter[port] == null
                                        && !(abstraction.looks().get(port) instanceof Unseen));
    }

    private Situation situation(Visit visit, Value[] letter) {
        return stepper.situation(
                visit,
                letter,
                reaction -> {
                    Place place = new Place(reaction.next(), stepper.latched(visit, letter));
                    return propose(place, visit, letter, reaction.output());
                });
    }

    /** Keeps the better of two ways that are equally long. */
    private int propose(
            Place place, @Nullable Visit before, Value @Nullable [] letter, Output output) {
        Visit known = visits.get(place);
        if (known != null) {
            return known.number();
        }
        Visit other = next.get(place);
        int messages =
                before == null || letter == null ? 0 : before.messages() + Letters.messages(letter);
        if (other != null && other.messages() <= messages) {
            return other.number();
        }
        int number = other == null ? byNumber.size() : other.number();
        int length = before == null ? 0 : before.length() + 1;
        Visit visit =
                new Visit(
                        number,
                        place.configuration(),
                        place.latched(),
                        before,
                        letter,
                        output,
                        length,
                        messages);
        next.put(place, visit);
        if (other == null) {
            byNumber.add(visit);
            shown.add(new RunProperty.Reached(place.configuration().state()));
        } else {
            byNumber.set(number, visit);
        }
        return number;
    }

    /** Whether everything that can be reached has been seen. */
    public boolean isComplete() {
        return obstacle.isEmpty();
    }

    /** Why not everything has been seen; else empty. */
    public String obstacle() {
        return obstacle;
    }

    /** Whether transitions lead to a state, whatever their guards say. */
    public boolean isConnected(int state) {
        return connected.get(state);
    }

    /** What some run shows, as far as it was looked at. */
    public Set<RunProperty> shown() {
        return shown;
    }

    public Visit visit(int number) {
        return byNumber.get(number);
    }

    /** How many configurations were met. */
    public int size() {
        return byNumber.size();
    }
}
