package arcomat.generate.plan;

import arcomat.generate.text.FileContext;
import arcomat.model.Automaton;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Which transitions stand for statements that are written as statements. A target asks for that by
 * the entry {@code statements}; others get the ways through them as transitions.
 *
 * @param draws whether one is drawn of transitions that are enabled together; who draws asks all of
 *     them before anything is done
 * @param traced whether the number of the transition is noted
 */
record Blocks(FileContext context, Automaton automaton, boolean draws, boolean traced) {
    /**
     * Some transitions that follow each other.
     *
     * @param first position of the first of them in the automaton
     * @param body what all of them stand for; else there is one
     */
    record Group(
            int first, List<Automaton.Transition> transitions, Optional<Automaton.Body> body) {}

    /** All transitions, in their order. */
    List<Group> groups() {
        List<Automaton.Transition> all = automaton.transitions();
        List<Group> groups = new ArrayList<>();
        int next = 0;
        while (next < all.size()) {
            Automaton.Transition first = all.get(next);
            int count = isWritten(first, next) ? first.body().orElseThrow().transitions() : 1;
            Optional<Automaton.Body> body =
                    isWritten(first, next) ? first.body() : Optional.empty();
            groups.add(new Group(next, all.subList(next, next + count), body));
            next += count;
        }
        return groups;
    }

    private boolean isWritten(Automaton.Transition first, int position) {
        return isAsked()
                && first.body()
                        .filter(body -> isWhole(body, position))
                        .filter(body -> !traced || body.isNumbered() || body.transitions() == 1)
                        .filter(body -> automaton.before(first).isEmpty())
                        .filter(body -> !draws || isAlone(first.source(), body.transitions()))
                        .isPresent();
    }

    private boolean isAsked() {
        return context.names().language().entry("statements").isPresent();
    }

    /** Whether all that stand for the statements are there, as they were made. */
    private boolean isWhole(Automaton.Body body, int position) {
        List<Automaton.Transition> all = automaton.transitions();
        int end = position + body.transitions();
        return end <= all.size()
                && all.subList(position, end).stream()
                        .allMatch(each -> each.body().filter(b -> b == body).isPresent());
    }

    private boolean isAlone(int state, int ways) {
        return automaton.transitions().stream().filter(each -> each.source() == state).count()
                == ways;
    }
}
