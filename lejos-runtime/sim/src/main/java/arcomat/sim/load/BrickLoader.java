package arcomat.sim.load;

import arcomat.sim.device.Hardware;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * The classes of one brick. What is static in a program or in lejos.* exists once per brick. A
 * program sees its own classes, lejos.* and the JDK, and nothing else of this process.
 */
public final class BrickLoader extends ClassLoader implements Hardware.Inside {
    private static final MethodType PLAIN = MethodType.methodType(void.class);
    private static final MethodType MAIN = MethodType.methodType(void.class, String[].class);

    private static final MethodType RUN = MethodType.methodType(void.class, int.class);
    private static final MethodType GO_ON =
            MethodType.methodType(void.class, Object.class, int.class);

    private final Stock stock;

    /** What classes do to be as if they had just been loaded. */
    private final List<MethodHandle> forgetting = new ArrayList<>();

    private @Nullable Hardware hardware;
    private @Nullable MethodHandle goOn;

    BrickLoader(Stock stock) {
        super("brick", BrickLoader.class.getClassLoader());
        this.stock = stock;
    }

    @Override
    public Hardware hardware() {
        return Objects.requireNonNull(hardware);
    }

    /** Belongs to a brick from now on. */
    void beginFor(Hardware next) {
        hardware = next;
    }

    /**
     * Belongs to no brick any more, and is as if nothing had been loaded: another brick may have
     * it. The program must be over, with all its threads.
     */
    public void leave() {
        if (stock.repeats()) {
            forgetting.forEach(BrickLoader::call);
            hardware = null;
            stock.add(this);
        }
    }

    /**
     * The program's main, whose class has begun. A handle: Java replaces a reflected method that is
     * called again and again by a class of its own, which this loader would have to find.
     *
     * @throws ReflectiveOperationException if there is none
     */
    public MethodHandle main(String mainClass) throws ReflectiveOperationException {
        Class<?> type = loadClass(mainClass);
        Method main = type.getDeclaredMethod("main", String[].class);
        if (!Modifier.isStatic(main.getModifiers())) {
            throw new NoSuchMethodException("main is not static");
        }
        MethodHandle handle = lookup(type).unreflect(main).asType(MAIN);
        if (stock.repeats()) {
            hidden(type, Repetition.READY).ifPresent(BrickLoader::call);
        }
        return handle;
    }

    /** Has a robot go on whose thread has rested. */
    public void goOn(Object robot) {
        try {
            if (goOn == null) {
                Class<?> type = loadClass(SliceLoop.ROBOT);
                goOn = lookup(type).findVirtual(type, SliceLoop.RUN.name(), RUN).asType(GO_ON);
            }
            goOn.invokeExact(robot, 0); // its cycle is what it was
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new AssertionError("it declares none", e);
        }
    }

    /** Its class need not be public. */
    private static MethodHandles.Lookup lookup(Class<?> type) throws IllegalAccessException {
        return MethodHandles.privateLookupIn(type, MethodHandles.lookup());
    }

    /** What {@link Repetition} has given to a class or to one above it. */
    private static Optional<MethodHandle> hidden(Class<?> type, String method) {
        try {
            return Optional.of(lookup(type).findStatic(type, method, PLAIN));
        } catch (NoSuchMethodException e) {
            return Optional.empty();
        } catch (IllegalAccessException e) {
            throw new AssertionError("no module closes it", e);
        }
    }

    private static void call(MethodHandle method) {
        try {
            method.invokeExact();
        } catch (RuntimeException | Error e) {
            throw e;
        } catch (Throwable e) {
            throw new AssertionError("it declares none", e);
        }
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            if (loaded != null) {
                return loaded;
            }
            return isShared(name) ? super.loadClass(name, resolve) : findClass(name);
        }
    }

    /** The JDK, and the simulation itself, where bricks meet. */
    static boolean isShared(String name) {
        return name.startsWith("java.") || name.startsWith("arcomat.sim.") && !isInside(name);
    }

    static boolean isInside(String name) {
        return isOfTheBrick(name) || name.startsWith("arcomat.sim.inside.");
    }

    /** Classes that are leJOS' for programs. */
    static boolean isOfTheBrick(String name) {
        return name.startsWith("lejos.") || name.startsWith("javax.microedition.");
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        byte[] classFile = stock.files().find(name).orElseThrow(() -> missing(name));
        Class<?> type = defineClass(name, classFile, 0, classFile.length);
        if (stock.repeats()) {
            hidden(type, Repetition.FORGET).ifPresent(forgetting::add);
        }
        return type;
    }

    private static ClassNotFoundException missing(String name) {
        return new ClassNotFoundException(
                name + (isInside(name) ? " is not simulated" : " is not in the program's jar"));
    }
}
