package arcomat.campaign.coverage;

import java.util.ArrayList;
import java.util.List;

/**
 * What the runs of a campaign may cover, numbered from 0: all transitions, automaton by automaton,
 * then all beginnings. An automaton is covered by whichever part comes to it; where several parts
 * have it, the transitions and beginnings of each follow behind that, part by part. States need no
 * numbers: a run was in one if it has taken a transition that leads there, or begun in it.
 *
 * @param parts that have these automata, in all robots
 * @param jars programs that were given as jars, without models: nobody knows what these cover
 */
public record CoverageItems(
        List<AutomatonItems> automata, List<PartItems> parts, List<String> jars) {
    /** Of programs without models. */
    public static final CoverageItems NONE = new CoverageItems(List.of(), List.of(), List.of());

    public CoverageItems {
        automata = List.copyOf(automata);
        parts = List.copyOf(parts);
        jars = List.copyOf(jars);
    }

    /** How many transitions there are; their numbers are below that. */
    public int transitions() {
        return automata.stream().mapToInt(each -> each.transitions().size()).sum();
    }

    /** How many states there are. */
    public int states() {
        return automata.stream().mapToInt(each -> each.states().size()).sum();
    }

    /** The numbers of an automaton, whichever part comes to it, by its place among the automata. */
    public ItemNumbers ofAutomaton(int place) {
        int transition = 0;
        int initial = transitions();
        for (AutomatonItems each : automata.subList(0, place)) {
            transition += each.transitions().size();
            initial += each.initials().size();
        }
        return new ItemNumbers(transition, initial);
    }

    /** For each part its numbers; of one that has its automaton for itself, those of that. */
    public List<ItemNumbers> ofParts() {
        int next = transitions() + automata.stream().mapToInt(a -> a.initials().size()).sum();
        List<ItemNumbers> numbers = new ArrayList<>();
        for (PartItems part : parts) {
            if (isShared(part)) {
                AutomatonItems automaton = automata.get(part.automaton());
                int initial = next + automaton.transitions().size();
                numbers.add(new ItemNumbers(next, initial));
                next = initial + automaton.initials().size();
            } else {
                numbers.add(ofAutomaton(part.automaton()));
            }
        }
        return numbers;
    }

    /** Whether other parts have the automaton of a part, too. */
    public boolean isShared(PartItems part) {
        return parts.stream()
                .anyMatch(each -> each.automaton() == part.automaton() && !each.equals(part));
    }
}
