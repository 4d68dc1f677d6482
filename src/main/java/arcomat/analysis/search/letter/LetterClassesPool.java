package arcomat.analysis.search.letter;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.model.Port;
import arcomat.semantics.value.Attention;
import arcomat.semantics.value.Attention.Look;
import arcomat.semantics.value.SmallType;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The foci of one side, numbered; there is one for all configurations that look at the same. */
public final class LetterClassesPool {
    private final List<Port> inputs;
    private final Budget budget;
    private final Map<Attention, LetterClasses> known = new HashMap<>();

    public LetterClassesPool(List<Port> inputs, Budget budget) {
        this.inputs = inputs;
        this.budget = budget;
    }

    public LetterClasses of(Attention attention) {
        return known.computeIfAbsent(
                attention, each -> new LetterClasses(known.size(), paid(each), inputs));
    }

    private Attention paid(Attention attention) {
        Attention all = new Attention(all(attention));
        boolean alike = !attention.equals(all) && budget.takes(Shortcut.ALIKE);
        return alike ? attention : all;
    }

    /** A look at every single message, where these can be tried. */
    private List<Look> all(Attention attention) {
        List<Look> looks = new ArrayList<>();
        for (int port = 0; port < inputs.size(); port++) {
            boolean few = SmallType.values(inputs.get(port).type()).isPresent();
            looks.add(few ? new Attention.Whole() : attention.looks().get(port));
        }
        return looks;
    }
}
