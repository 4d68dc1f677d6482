package arcomat.cli.terminal;

import arcomat.model.Letter;
import arcomat.pipeline.simulate.Dialogue;
import arcomat.simulate.run.Question;

/** Nobody to talk to: for runs that decide by themselves. */
public final class SilentDialogue implements Dialogue {
    @Override
    public void stepBegins(int number, Letter inputs) {
        // nobody listens
    }

    @Override
    public int ask(Question question) {
        throw new IllegalStateException("nobody is there to be asked");
    }
}
