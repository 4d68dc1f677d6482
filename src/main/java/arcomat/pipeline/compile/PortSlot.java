package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Optional;

/** A port at the border of compiled code: the fields for its message and its presence. */
final class PortSlot {
    private final String name;
    private final HeldMessage held;
    private final JavaValues messages;

    /**
     * @param name as letters have it
     */
    PortSlot(String name, Port port, Object owner, CodeLayout.Place place, JavaValues messages) {
        this.name = name;
        this.held = HeldMessage.of(port, owner, place, messages.read());
        this.messages = messages;
    }

    String name() {
        return name;
    }

    void write(Letter letter) {
        Optional<Value> value = letter.message(name);
        held.presence().ifPresent(slot -> slot.set(value.isPresent()));
        if (value.isPresent()) {
            held.message().set(messages.toJava(value.get(), held.port().type()));
        } else if (held.port().type() instanceof Type.EnumType) {
            held.message().set(0);
        }
    }

    Optional<Value> read() {
        return held.read();
    }
}
