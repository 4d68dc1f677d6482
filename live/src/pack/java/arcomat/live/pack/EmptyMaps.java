package arcomat.live.pack;

import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.MethodDescriptor;
import org.teavm.model.MethodHolder;
import org.teavm.model.emit.ProgramEmitter;
import org.teavm.model.emit.ValueEmitter;
import org.teavm.model.util.ProgramUtils;

/**
 * Has empty maps say that they have nothing. Where {@code Map.copyOf} gives one, TeaVM's begins to
 * look at the remainder of a division by its size, which is no place in scripts and an error in
 * Java.
 */
public final class EmptyMaps implements ClassHolderTransformer {
    private static final String MAP = "java.util.TemplateCollections$NEtriesMap";
    private static final String OF_SOME = "getOfSome";
    private static final MethodDescriptor GET =
            new MethodDescriptor("get", Object.class, Object.class);

    @Override
    public void transformClass(ClassHolder type, ClassHolderTransformerContext context) {
        if (!type.getName().equals(MAP)) {
            return;
        }
        MethodHolder get = type.getMethod(GET);
        MethodHolder ofSome = new MethodHolder(OF_SOME, GET.getSignature());
        ofSome.setLevel(get.getLevel());
        ofSome.setProgram(ProgramUtils.copy(get.getProgram()));
        type.addMethod(ofSome);
        ProgramEmitter body = ProgramEmitter.create(get, context.getHierarchy());
        ValueEmitter map = body.var(0, type);
        body.when(map.invokeVirtual("isEmpty", boolean.class).isTrue())
                .thenDo(() -> body.constantNull(Object.class).returnValue());
        map.invokeSpecial(OF_SOME, Object.class, body.var(1, Object.class)).returnValue();
    }
}
