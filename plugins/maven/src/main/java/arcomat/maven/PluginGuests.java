package arcomat.maven;

import java.io.File;
import java.io.IOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Guests of the tool: whoever names one among the dependencies of the plugin wants it to take part,
 * as for other plugins that look at texts by rules.
 */
final class PluginGuests {
    private static final String SERVICE = "META-INF/services/arcomat.guest.Guest";

    private PluginGuests() {}

    /**
     * Those that are guests: jars, and in a build of several modules also folders of classes.
     *
     * @param plugin sees the plugin and its dependencies
     */
    static List<File> of(ClassLoader plugin) throws IOException {
        List<File> guests = new ArrayList<>();
        for (URL service : Collections.list(plugin.getResources(SERVICE))) {
            guests.add(new File(place(service)));
        }
        return guests;
    }

    private static URI place(URL service) throws IOException {
        try {
            if (service.openConnection() instanceof JarURLConnection jar) {
                return jar.getJarFileURL().toURI();
            }
            String text = service.toString();
            return new URI(text.substring(0, text.length() - SERVICE.length()));
        } catch (URISyntaxException e) {
            throw new IOException(e);
        }
    }
}
