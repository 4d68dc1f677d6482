package arcomat.simulate.run;

import arcomat.model.FirstValue;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.Optional;

/** The first of everything. */
final class FirstChoice implements Choice {
    @Override
    public boolean isTextOrder() {
        return true;
    }

    @Override
    public int pick(Question question) {
        return 0;
    }

    @Override
    public Optional<Value> message(Port port, boolean required) {
        return required ? Optional.of(FirstValue.of(port.type())) : Optional.empty();
    }
}
