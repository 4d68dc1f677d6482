package arcomat.pipeline;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;

/** A method of one object of compiled code. */
final class Call implements Runnable {
    private final Object owner;
    private final Method method;

    Call(Object owner, String name) {
        this.owner = owner;
        this.method = find(owner.getClass(), name);
        method.setAccessible(true);
    }

    /** The most special one of that name; generated classes name each method once. */
    private static Method find(Class<?> type, String name) {
        for (Method method : type.getDeclaredMethods()) {
            if (method.getName().equals(name)) {
                return method;
            }
        }
        if (type.getSuperclass() == null) {
            throw new IllegalStateException("no method " + name);
        }
        return find(type.getSuperclass(), name);
    }

    @Override
    public void run() {
        with();
    }

    void with(Object... arguments) {
        try {
            method.invoke(owner, arguments);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof RuntimeException problem) {
                throw problem;
            }
            throw new IllegalStateException(e);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }
}
