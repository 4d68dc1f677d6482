package arcomat.analysis;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.value.SmallType;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Question;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Decides run after run, each time in another way; the first alternative where all is new. */
public final class Script implements Choice {
    private final int most;
    private final List<Integer> picks = new ArrayList<>();
    private final List<Integer> counts = new ArrayList<>();
    private int position;

    /**
     * @param most more choices in one run are taken for a circle
     */
    public Script(int most) {
        this.most = most;
    }

    @Override
    public int pick(Question question) {
        return pick(question.count());
    }

    private int pick(int count) {
        if (position == most) {
            throw new ModelError("messages circle");
        }
        if (position == picks.size()) {
            picks.add(0);
            counts.add(count);
        }
        return picks.get(position++);
    }

    @Override
    public Optional<Value> message(Port port, boolean required) {
        List<Value> values = SmallType.values(port.type()).orElseThrow();
        int picked = pick(values.size() + (required ? 0 : 1));
        return picked == values.size() ? Optional.empty() : Optional.of(values.get(picked));
    }

    /** Prepares the next run; false if this was the last. */
    public boolean advance() {
        position = 0;
        while (!picks.isEmpty()) {
            int last = picks.size() - 1;
            if (picks.get(last) + 1 < counts.get(last)) {
                picks.set(last, picks.get(last) + 1);
                return true;
            }
            picks.remove(last);
            counts.remove(last);
        }
        return false;
    }
}
