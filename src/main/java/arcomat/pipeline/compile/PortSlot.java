package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Objects;
import java.util.Optional;

/** A port at the border of compiled code: the fields for its message and its presence. */
final class PortSlot {
    private final String name;
    private final Port port;
    private final Slot message;
    private final Optional<Slot> presence;
    private final JavaValues messages;

    /**
     * @param name as letters have it
     */
    PortSlot(String name, Port port, Object owner, CodeLayout.Place place, JavaValues messages) {
        this.name = name;
        this.port = port;
        this.message = new Slot(owner, Objects.requireNonNull(place.messages().get(port.name())));
        this.presence =
                Optional.ofNullable(place.presences().get(port.name()))
                        .map(field -> new Slot(owner, field));
        this.messages = messages;
    }

    String name() {
        return name;
    }

    void write(Letter letter) {
        Optional<Value> value = letter.message(name);
        presence.ifPresent(slot -> slot.set(value.isPresent()));
        if (value.isPresent()) {
            message.set(messages.toJava(value.get(), port.type()));
        } else if (port.type() instanceof Type.EnumType) {
            message.set(0);
        }
    }

    Optional<Value> read() {
        Object held = message.get();
        boolean absent =
                presence.isPresent()
                        ? presence.get().get().equals(false)
                        : port.type() instanceof Type.EnumType && held.equals(0);
        return absent ? Optional.empty() : Optional.of(messages.fromJava(held, port.type()));
    }
}
