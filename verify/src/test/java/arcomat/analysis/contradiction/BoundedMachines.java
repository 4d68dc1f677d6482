package arcomat.analysis.contradiction;

import arcomat.analysis.game.Outcomes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Every machine of a bounded number of states, tried against some requirements: what it does in a
 * state with an input is chosen when it is first asked for, and chosen otherwise where that breaks
 * a requirement. Shares nothing with the game.
 */
final class BoundedMachines {
    /** A choice for a state and an input: the number of the answer, and the state afterwards. */
    private record Reaction(int answer, int next) {}

    /** A machine's state with a position of the requirements that it may meet. */
    private record Meeting(int state, int position) {}

    private final Outcomes outcomes;
    private final int letters;
    private final Reaction[][] table;
    private final List<Meeting> agenda = new ArrayList<>();
    private final Set<Meeting> met = new LinkedHashSet<>();
    private long patience;

    private BoundedMachines(Outcomes outcomes, int states, long patience) {
        this.outcomes = outcomes;
        this.letters = outcomes.inputs().size();
        this.table = new Reaction[states][letters];
        this.patience = patience;
    }

    /**
     * Whether some machine keeps the requirements.
     *
     * @param patience how many choices are tried
     * @return empty where that does not suffice
     */
    static Optional<Boolean> someKeeps(Outcomes outcomes, int states, long patience) {
        BoundedMachines all = new BoundedMachines(outcomes, states, patience);
        for (int opening : Arrays.stream(outcomes.openings()).distinct().toArray()) {
            if (opening != Outcomes.BROKEN) {
                all.add(0, opening);
                if (all.fulfil(0, 0, 1)) {
                    return Optional.of(true);
                }
                all.shorten(0);
            }
        }
        return all.patience < 0 ? Optional.empty() : Optional.of(false);
    }

    private void add(int state, int position) {
        Meeting meeting = new Meeting(state, position);
        if (position != Outcomes.END && met.add(meeting)) {
            agenda.add(meeting);
        }
    }

    private void shorten(int size) {
        while (agenda.size() > size) {
            met.remove(agenda.remove(agenda.size() - 1));
        }
    }

    /**
     * @param used how many states there are so far
     */
    private boolean fulfil(int item, int letter, int used) {
        if (item == agenda.size()) {
            return true;
        }
        if (patience-- < 0) {
            return false;
        }
        Meeting meeting = agenda.get(item);
        int next = letter + 1 < letters ? letter + 1 : 0;
        int nextItem = letter + 1 < letters ? item : item + 1;
        if (!outcomes.isPossible(meeting.position, outcomes.inputs().get(letter))) {
            return fulfil(nextItem, next, used);
        }
        int[] answers = outcomes.answers(meeting.position, outcomes.inputs().get(letter));
        Reaction decided = table[meeting.state][letter];
        if (decided != null) {
            return answers[decided.answer] != Outcomes.BROKEN
                    && goOn(decided.next, answers[decided.answer], nextItem, next, used);
        }
        for (int answer = 0; answer < answers.length; answer++) {
            int states = answers[answer] == Outcomes.END ? 1 : Math.min(used + 1, table.length);
            for (int state = 0; state < states; state++) {
                if (answers[answer] != Outcomes.BROKEN) {
                    table[meeting.state][letter] = new Reaction(answer, state);
                    int more = Math.max(used, state + 1);
                    if (goOn(state, answers[answer], nextItem, next, more)) {
                        return true;
                    }
                    table[meeting.state][letter] = null;
                }
            }
        }
        return false;
    }

    private boolean goOn(int state, int position, int item, int letter, int used) {
        int size = agenda.size();
        add(state, position);
        if (fulfil(item, letter, used)) {
            return true;
        }
        shorten(size);
        return false;
    }
}
