package arcomat.check.guest;

import arcomat.check.law.Check;
import arcomat.check.law.Check.Context;
import arcomat.check.law.Law;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.tree.Unit;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Stands between the walk and a check of a guest: it is shown the same things, and what it throws
 * is told to somebody else. A check that has thrown is not asked again in the same run.
 */
final class GuardedCheck implements InvocationHandler {
    /** Told what went wrong, and what the check looked at. */
    interface Failures {
        void add(Law law, Span place, Throwable thrown);
    }

    private final Law law;
    private final Failures failures;
    private boolean hasFailed;

    private GuardedCheck(Law law, Failures failures) {
        this.law = law;
        this.failures = failures;
    }

    /** The same law, with a check that does not throw. */
    static Law around(Law law, Failures failures) {
        Class<?>[] kinds =
                Stream.concat(
                                Stream.of(Check.class),
                                Arrays.stream(Check.class.getDeclaredClasses())
                                        .filter(Check.class::isAssignableFrom))
                        .filter(kind -> kind.isInstance(law.check()))
                        .toArray(Class<?>[]::new);
        Object guarded =
                Proxy.newProxyInstance(
                        Check.class.getClassLoader(), kinds, new GuardedCheck(law, failures));
        return new Law(
                law.code(), law.inRequirements(), law.inExecutable(), law.needs(), (Check) guarded);
    }

    @Override
    public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] shown)
            throws IllegalAccessException {
        List<Object> things = shown == null ? List.of() : Arrays.asList(shown);
        if (hasFailed) {
            return null;
        }
        try {
            return method.invoke(law.check(), shown);
        } catch (InvocationTargetException e) {
            hasFailed = true;
            failures.add(law, place(things), e.getCause() == null ? e : e.getCause());
            return null;
        }
    }

    /** The component around what is shown, or the beginning of the file. */
    private static Span place(List<Object> things) {
        for (Object thing : things) {
            if (thing instanceof Context context) {
                return context.component()
                        .map(component -> component.node().name().span())
                        .orElse(start(context.unit()));
            }
            if (thing instanceof Workspace workspace) {
                return start(workspace.units().iterator().next());
            }
        }
        throw new IllegalArgumentException("shown without a context: " + things);
    }

    private static Span start(Unit unit) {
        return unit.file().span(0, 0);
    }
}
