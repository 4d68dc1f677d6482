package arcomat.generate.views;

import arcomat.generate.view.AtomicView.LineView;
import arcomat.generate.view.AtomicView.StateView;
import arcomat.generate.view.AtomicView.TransitionView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;

import java.util.ArrayList;
import java.util.List;

/**
 * Estimates the size of code, in bytes of a virtual machine, from above: a word of source text is
 * at most eight bytes. HotSpot never compiles a method of 8,000 bytes or more.
 */
public final class MethodSize {
    static final int MOST = 6000;

    private static final int PER_WORD = 8;

    /** What an expression may have that leaves room for others. */
    static final int MOST_WORDS = MOST / PER_WORD;

    /** Calls with an object that is reached by three fields, in {@link #MOST} bytes. */
    static final int MOST_CALLS = 300;

    private static final int PER_TRANSITION = 24;
    private static final int PER_STATE = 12;

    private MethodSize() {}

    static boolean fits(List<TransitionView> transitions) {
        return transitions.stream().mapToInt(MethodSize::of).sum() <= MOST;
    }

    /** How many states share a method; 0 where all of them do. */
    static int statesPerMethod(List<StateView> states) {
        int size = states.size();
        while (size > 1 && largest(states, size) > MOST) {
            size = (size + 1) / 2;
        }
        return size == states.size() ? 0 : size;
    }

    private static int largest(List<StateView> states, int size) {
        int largest = 0;
        int sum = 0;
        for (int i = 0; i < states.size(); i++) {
            sum = i % size == 0 ? 0 : sum;
            sum += of(states.get(i));
            largest = Math.max(largest, sum);
        }
        return largest;
    }

    private static int of(StateView state) {
        return PER_STATE
                + state.chunks().size() * PER_STATE
                + state.transitions().stream().mapToInt(MethodSize::of).sum();
    }

    static List<List<TransitionView>> split(List<TransitionView> transitions) {
        List<List<TransitionView>> parts = new ArrayList<>();
        int sum = MOST;
        for (TransitionView transition : transitions) {
            sum += of(transition);
            if (sum > MOST) {
                parts.add(new ArrayList<>());
                sum = of(transition);
            }
            parts.get(parts.size() - 1).add(transition);
        }
        return parts;
    }

    static int of(TransitionView transition) {
        int words = words(transition.condition());
        for (FieldView local : transition.locals()) {
            words += 1 + words(local.initial());
        }
        for (AssignmentView message : transition.messages()) {
            words += 1 + words(message.value());
        }
        for (AssignmentView assignment : transition.assignments()) {
            words += words(assignment.target()) + words(assignment.value());
        }
        for (LineView line : transition.statements().lines()) {
            words += 1 + words(line.target()) + words(line.value());
        }
        return PER_TRANSITION + words * PER_WORD;
    }

    /** Identifiers with their qualifiers, and numbers. */
    static int words(String text) {
        int words = 0;
        boolean inside = false;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean part = Character.isJavaIdentifierPart(c) || c == '.' && inside;
            words += part && !inside ? 1 : 0;
            inside = part;
        }
        return words;
    }
}
