package arcomat.live.pack;

import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.MethodHolder;
import org.teavm.model.emit.ProgramEmitter;

import java.util.List;

/**
 * Takes out of the solver what it only makes for questions of other kinds: ours are about whole
 * numbers and truth values, and ask for no proof. Where it would make such a thing after all, there
 * is an error, and no answer.
 */
public final class NeverMade implements ClassHolderTransformer {
    private static final String SOLVER = "de.uni_freiburg.informatik.ultimate.smtinterpol.";

    private static final List<String> CLASSES =
            List.of(
                    "interpolate.Interpolator",
                    "proof.MinimalProofChecker",
                    "proof.ProofSimplifier",
                    "theory.cclosure.ArrayTheory",
                    "theory.cclosure.CCProofGenerator",
                    "theory.cclosure.DataTypeTheory",
                    "theory.quant.QuantifierTheory");

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        String name = type.getName();
        if (name.startsWith(SOLVER) && CLASSES.contains(name.substring(SOLVER.length()))) {
            for (MethodHolder method : type.getMethods()) {
                if (method.getName().equals("<init>")) {
                    ProgramEmitter body = ProgramEmitter.create(method, context.getHierarchy());
                    body.construct(UnsupportedOperationException.class, body.constant(name))
                            .raise();
                }
            }
        }
    }
}
