component Lamp { feature dimmer,alarm ; constraint(alarm implies dimmer);
varif(dimmer){port out Integer level; varif (alarm) { } else varif(!alarm) { component Inner { port in Boolean feature; varif (dimmer) {autoconnect port;} } } }
else { port in Boolean constraint, out Boolean varif; }
varif (a) { } else { }
}
