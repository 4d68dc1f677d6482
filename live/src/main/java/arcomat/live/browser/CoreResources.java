package arcomat.live.browser;

import org.teavm.classlib.ResourceSupplier;
import org.teavm.classlib.ResourceSupplierContext;

/** What the core reads of the tool's resources; the compiler puts it into the script. */
@SuppressWarnings(
        "deprecation") // there is no other way yet to name a resource without one of TeaVM's
// plug-ins
public final class CoreResources implements ResourceSupplier {
    @Override
    public String[] supplyResources(ResourceSupplierContext context) {
        return new String[] {"diagram/glyph-widths.txt"};
    }
}
