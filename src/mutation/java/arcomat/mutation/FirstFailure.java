package arcomat.mutation;

import org.junit.jupiter.api.extension.DynamicTestInvocationContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;

/** Once a line of a file has noticed the change, the lines below it are not tried. */
public final class FirstFailure implements InvocationInterceptor {

    @Override
    public void interceptDynamicTest(
            Invocation<Void> invocation,
            DynamicTestInvocationContext dynamic,
            ExtensionContext context)
            throws Throwable {
        var store =
                context.getRoot().getStore(ExtensionContext.Namespace.create(FirstFailure.class));
        if (store.get("failed") != null) {
            invocation.skip();
            return;
        }
        try {
            invocation.proceed();
        } catch (Throwable failure) {
            store.put("failed", true);
            throw failure;
        }
    }
}
