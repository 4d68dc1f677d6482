package lejos.nxt.comm;

import arcomat.sim.radio.Link;

/** A connection over Bluetooth. */
public class BTConnection extends NXTConnection {
    BTConnection(Link link, int mode) {
        super(link, mode);
    }
}
