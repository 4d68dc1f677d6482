package arcomat.pipeline.simulate;

import arcomat.model.Letter;
import arcomat.simulate.run.Choice;

/** Somebody who is asked for decisions while a model runs, and told what happens meanwhile. */
public interface Dialogue extends Choice.Asker {
    /** Told before each step, so that questions about it can be understood. */
    void stepBegins(int number, Letter inputs);
}
