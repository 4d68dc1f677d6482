package p;

componet Door { }
