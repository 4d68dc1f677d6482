package arcomat.benchmarks.step;

import java.util.ArrayList;
import java.util.List;

/**
 * Fig. 6 as plain transitions of one event each, an event being a whole letter: the form that the
 * libraries take.
 *
 * @param cmd code of the command sent, 0 for none
 * @param timerCmd code of the timer command sent, 0 for none
 */
record Rule(int source, int letter, int target, int cmd, int timerCmd) {

    /** Every reaction of the automaton; where it does nothing there is no rule. */
    static List<Rule> all() {
        List<Rule> rules = new ArrayList<>();
        for (int state = 0; state < 5; state++) {
            for (int letter = 0; letter < Letters.ALPHABET; letter++) {
                IntSwitch machine = new IntSwitch();
                machine.state = state;
                machine.frontUS = Letters.frontUS(letter);
                machine.timerSig = Letters.timerSig(letter);
                machine.ls = Letters.ls(letter);
                machine.gotCoffee = Letters.gotCoffee(letter);
                machine.step();
                if (machine.state != state) {
                    rules.add(
                            new Rule(state, letter, machine.state, machine.cmd, machine.timerCmd));
                }
            }
        }
        return rules;
    }
}
