package arcomat.pipeline.compile;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;

/** A method of one object of compiled code. */
final class Call implements Runnable {
    private final Object owner;
    private final Method method;

    /**
     * @param parameters how many the method has
     */
    Call(Object owner, String name, int parameters) {
        this.owner = owner;
        this.method = find(owner.getClass(), name, parameters);
        method.setAccessible(true);
    }

    /** The most special one of that name: a port may be called like a method without parameters. */
    private static Method find(Class<?> type, String name, int parameters) {
        for (Method method : type.getDeclaredMethods()) {
            if (method.getName().equals(name) && method.getParameterCount() == parameters) {
                return method;
            }
        }
        if (type.getSuperclass() == null) {
            throw new IllegalStateException("no method " + name);
        }
        return find(type.getSuperclass(), name, parameters);
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
