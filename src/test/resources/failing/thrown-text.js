// says: text thrown
throw "text thrown";
