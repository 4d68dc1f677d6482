package arcomat.live.browser;

import org.teavm.jso.JSExportClasses;

/** Names what scripts may make; the compiler begins here. */
@JSExportClasses(Core.class)
public final class Door {
    private Door() {}
}
