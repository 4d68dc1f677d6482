package arcomat.analysis.mona;

import arcomat.analysis.mona.ExplicitSystem.Step;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;

/**
 * Numbers for steps, such that state, letter and number determine the next state: a greedy
 * colouring of steps that a letter leaves open.
 *
 * <p>States that are hidden cost MONA one determinisation for each of their bits, and all of them
 * but one meet sets of sets. With hidden choices it is cheap to hide the states, which follow from
 * the choices, and only hiding the choices is the subset construction. In trials with random
 * automata of 16 states that made the difference between half a second and no memory left.
 */
final class Alternatives {
    private Alternatives() {}

    /** One number per step, from 0; as few as possible are not guaranteed. */
    static List<Integer> number(List<Step> steps) {
        List<Integer> numbers = new ArrayList<>();
        for (int i = 0; i < steps.size(); i++) {
            List<Integer> taken = new ArrayList<>();
            for (int other = 0; other < i; other++) {
                if (isUndecided(steps.get(i), steps.get(other))) {
                    taken.add(numbers.get(other));
                }
            }
            int number = 0;
            while (taken.contains(number)) {
                number++;
            }
            numbers.add(number);
        }
        return numbers;
    }

    /** Whether both may be taken with one letter, and lead to different states. */
    private static boolean isUndecided(Step one, Step two) {
        if (one.next() == two.next() || one.error() != two.error()) {
            return false;
        }
        for (int i = 0; i < one.inputs().size(); i++) {
            if (Collections.disjoint(one.inputs().get(i), two.inputs().get(i))) {
                return false;
            }
        }
        return one.error()
                || Objects.requireNonNull(one.sent())
                        .meet(Objects.requireNonNull(two.sent()))
                        .isPresent();
    }
}
