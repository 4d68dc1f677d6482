package arcomat.live.pack;

import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.ElementModifier;
import org.teavm.model.MethodDescriptor;
import org.teavm.model.MethodHolder;
import org.teavm.model.ValueType;
import org.teavm.model.emit.ProgramEmitter;

/**
 * Takes the texts out of the core that Java gives to things by itself: the name of an object's
 * class, and a record with all its parts. Nobody reads them on the page, and names of all classes
 * and parts would come along. Who asks for one gets no other text instead, but an error.
 */
public final class NeedlessTexts implements ClassHolderTransformer {
    private static final MethodDescriptor TEXT = new MethodDescriptor("toString", String.class);
    private static final MethodDescriptor CAST =
            new MethodDescriptor("cast", Object.class, Object.class);

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        MethodHolder text = type.getMethod(TEXT);
        if (text != null && (type.getName().equals("java.lang.Object") || isOfRecord(type, text))) {
            ProgramEmitter body = ProgramEmitter.create(text, context.getHierarchy());
            body.construct(UnsupportedOperationException.class, body.constant("no text")).raise();
        }
        if (type.getName().equals("java.lang.Class")) {
            castWithoutNames(type.getMethod(CAST), context);
        }
    }

    /** Whether Java has written it, who makes it final: records have others of their own. */
    private static boolean isOfRecord(ClassHolder type, MethodHolder text) {
        return "java.lang.Record".equals(type.getParent())
                && text.hasModifier(ElementModifier.FINAL);
    }

    /** Says that a cast is wrong, and not what stood there. */
    private static void castWithoutNames(
            MethodHolder method, ClassHolderTransformerContext context) {
        ProgramEmitter body = ProgramEmitter.create(method, context.getHierarchy());
        body.invoke(
                        "arcomat.live.browser.Casts",
                        "cast",
                        ValueType.object("java.lang.Object"),
                        body.var(0, Class.class),
                        body.var(1, Object.class))
                .returnValue();
    }
}
