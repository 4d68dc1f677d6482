package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;

import java.util.Set;

/** How often methods of a monitor's own class call some of what they inherit, at most. */
final class RequirementCalls extends MethodWeights {
    private static final String REQUIREMENT = "arcomat/rt/Requirement";

    private final String monitor;
    private final Set<String> names;

    RequirementCalls(Code code, LibraryCost library, String monitor, Set<String> names) {
        super(code, library);
        this.monitor = monitor;
        this.names = names;
    }

    /** In one of its methods, with those of its own that this one calls. */
    long in(String method, String descriptor) {
        return of(new MethodName(monitor, method, descriptor));
    }

    @Override
    protected long own(AbstractInsnNode instruction) {
        return instruction instanceof MethodInsnNode call && isMeant(call) ? 1 : 0;
    }

    private boolean isMeant(MethodInsnNode call) {
        return names.contains(call.name)
                && code.declaration(MethodName.of(call))
                        .filter(declared -> declared.owner().equals(REQUIREMENT))
                        .isPresent();
    }

    @Override
    protected boolean isLookedInto(MethodName method) {
        return method.owner().equals(monitor);
    }

    @Override
    protected long ofLibrary(MethodName method) {
        return 0;
    }
}
