package arcomat.simulate.run;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;

/** Notes what another choice decides, so that a run can be written down. */
final class RememberedChoice implements Choice {
    private final Choice choice;
    private final List<String> decisions;

    RememberedChoice(Choice choice, List<String> decisions) {
        this.choice = choice;
        this.decisions = decisions;
    }

    @Override
    public boolean isTextOrder() {
        return choice.isTextOrder();
    }

    @Override
    public int pick(Question question) {
        int picked = choice.pick(question);
        String instance = question.instance().isEmpty() ? "" : question.instance() + ": ";
        decisions.add(
                question.step()
                        + ": "
                        + instance
                        + question.description().apply(picked)
                        + ", one of "
                        + question.count());
        return picked;
    }

    @Override
    public Optional<Value> message(Port port, boolean required) {
        return choice.message(port, required);
    }
}
